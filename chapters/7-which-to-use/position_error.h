// SPDX-License-Identifier: MIT-0
/// @file
/// The error of a method in a thing of the level.
#pragma once
#include <cmath>

#include "level.h"
#include "measure/error.h"
#include "measure/method.h"
#include "measure/record.h"

/// The largest distance from where a thing should be [m]; infinite from a kilometre on.
template <class Scene>
double max_position_error(const measure::Method& method, const Scene& scene, double h,
                          double seconds) {
  const double error = measure::largest_error(method, scene, h, std::lround(seconds / h)).position;
  return error < 1000 ? error : INFINITY;
}

/// An error as a table shows it: below a ten-billionth of the table's unit only rounding is left.
/// @param error  in the unit of the table
inline measure::Cell or_rounding(double error) {
  return error < 1e-10 ? measure::Cell("rounding") : measure::Cell(error);
}
