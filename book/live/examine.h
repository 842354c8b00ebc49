// SPDX-License-Identifier: MIT-0
/// @file
/// What can be said of a method by trying it: its order, and which of the book's methods it is.
#pragma once
#include "live/own.h"

namespace live {

/// What a method turned out to be.
struct Examined {
  /// log2 of what halving the step divides the error by; not a number if it comes no nearer.
  double order;
  /// The book's name for the method that takes the same steps, "" if there is none.
  const char* is;
  /// How far their states are apart after some steps, as a share of their size.
  double apart;
};

/// The order of the method that a stand is in the place of, by the same trial.
double order_in_whose_place(const Stand& stand);

/// Tries a method on a spring that is no line, with drag and a push that grows with time.
Examined examine(Own& own);

}  // namespace live
