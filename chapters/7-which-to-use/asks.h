// SPDX-License-Identifier: MIT-0
/// @file
/// What a step asks for, as the list of the methods has it: for claims about what was counted.
#pragma once
#include "measure/method.h"
#include "measure/methods.h"

/// Evaluations of the acceleration in a step, and one for the derivatives of an implicit method.
inline double asks(const measure::Method& method) {
  double often = 1;  // those that take damping apart
  list::for_each(list::EveryGeneral(), [&](auto listed) {
    if (listed.function != method.function) return;
    const bool implicit = list::is_in<decltype(listed)>(list::EveryImplicit());
    often = double(listed.evaluations + (implicit ? 1 : 0));
  });
  return often;
}
