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
  /// The same of the method in whose place it stands.
  double right_order;
  /// Its error in short steps, as a multiple of that method's.
  double off;
  /// The book's name for the method that takes the same steps, "" if there is none.
  const char* is;
  /// How far their states are apart after some steps, as a share of their size.
  double apart;
  /// How far a step of 0.1 s moves the place where nothing pushes, as a share of what is right.
  double drifts;
  /// How much it changes the velocity under a constant push, as a share of what is right.
  double kicks;
};

/// Tries what stands in the place of a method, and that method, on a spring that is no line, with
/// drag and a push that grows with time.
Examined examine(const Stand& stand);

}  // namespace live
