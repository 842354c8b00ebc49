// SPDX-License-Identifier: MIT-0
/// @file
/// The skydiver of chapter 2 and her parachute, braked implicitly.
#pragma once
#include <cmath>
#include <vector>

#include "../cast.h"
#include "integrate/backward_euler.h"

inline constexpr double slow = 0.1;  ///< ten steps a second [s]

/// The linear system of a single unknown is a division.
inline constexpr auto solve_parachute = [](double, double v, double, double, double q,
                                           double& change) {
  change = change / (1 + q * (-2 * parachute.k * std::abs(v)));
  return true;
};

/// Her velocity after a step of backward Euler, by the formula for the root of its equation [m/s].
/// @param v  before the step; downwards [m/s]
inline double derived_parachute(double v, double h) {
  const double hk = h * parachute.k;
  return (1 - std::sqrt(1 + 4 * hk * (h * parachute.g - v))) / (2 * hk);
}

/// Her velocity by one solve of the linear system; NaN if it failed [m/s].
inline double parachute_solved_once(double v, double h) {
  double x = 0;
  return integrate::backward_euler(x, v, 0.0, h, parachute, solve_parachute) ? v : NAN;
}

/// The changes of her velocity in Newton's iterations of the step in which it opens [m/s].
inline std::vector<double> changes_of_parachute() {
  std::vector<double> found;
  const auto note = [&found](double change) {
    found.push_back(std::abs(change));
    return found.back();
  };
  double x = 0, v = diving;
  const int iterations =
      integrate::backward_euler_newton(x, v, 0.0, slow, parachute, solve_parachute, note, 1e-9);
  if (iterations == 0) found.clear();
  return found;
}
