// SPDX-License-Identifier: MIT-0
/// @file
/// The drop that tells one step from another.
#pragma once
#include "../cast.h"
#include "measure/run.h"
#include "scenes/linear_drag.h"

// [drop]
/// How far a thing falls from rest in ten steps, each cut into substeps, in units of g h^2.
template <class Step>
double fallen(Step step, int substeps = 1) {
  constexpr scenes::LinearDrag<> fall{.c = 0};
  const auto end = measure::after(step, fall, fall.start(), frame / substeps, 10 * substeps);
  return -end.x / (fall.g * frame * frame);
}
// [drop]
