// SPDX-License-Identifier: MIT-0
/// @file
/// How long a step of Runge-Kutta may be, in chapter 3.
#pragma once
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "measure/methods.h"
#include "measure/record.h"
#include "measure/stability.h"
#include "toys.h"

/// The largest stable h omega of a damped spring, by the polynomial of the method.
/// @param coefficients  of R(z), the constant first
inline double limit_by_polynomial(const std::vector<double>& coefficients, double zeta) {
  using Complex = std::complex<double>;
  const auto size = [&](double homega) {
    const Complex root = std::sqrt(Complex(zeta * zeta - 1));
    const auto factor = [&](Complex z) {
      Complex sum = 0;
      for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) sum = *c + z * sum;
      return std::abs(sum);
    };
    return std::max(factor(homega * (-zeta + root)), factor(homega * (-zeta - root)));
  };
  double stable = 0, unstable = 10;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (stable + unstable) / 2;
    (size(middle) > 1 ? unstable : stable) = middle;
  }
  return stable;
}

/// The longest stable steps: found by running, and by the polynomials of the methods.
inline void limits(measure::Record& record) {
  auto& found = record.table("limits", {{"ζ"}, {"Euler"}, {"midpoint"}, {"RK4"}});
  for (int tenths = 1; tenths <= 30; ++tenths) {
    const scenes::Spring<> spring{.zeta = tenths / 10.0};
    found.add({spring.zeta, measure::stability_limit(measure::euler, spring, 1e-6, 10),
               measure::stability_limit(measure::midpoint, spring, 1e-6, 10),
               measure::stability_limit(measure::rk4, spring, 1e-6, 10)});
  }
  auto& lines = record.table("limit-lines", {{"ζ"}, {"Euler"}, {"midpoint"}, {"RK4"}});
  for (int hundredths = 0; hundredths <= 310; hundredths += 2) {
    const double zeta = hundredths / 100.0;
    lines.add({zeta, limit_by_polynomial({1, 1}, zeta), limit_by_polynomial({1, 1, 0.5}, zeta),
               limit_by_polynomial({1, 1, 0.5, 1.0 / 6, 1.0 / 24}, zeta)});
  }
  const auto steps_for_door = [](auto step) {
    return std::ceil(1 / measure::stability_limit(step, door, 1e-3, 0.1));
  };
  record.number("door-euler", steps_for_door(measure::euler), measure::whole);
  record.number("door-rk4-evaluations", 4 * steps_for_door(measure::rk4), measure::whole);
}
