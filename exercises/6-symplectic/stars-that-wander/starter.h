// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// What one star does to another at a distance: an acceleration [m/s^2], for mu in m^3/s^2.
inline Vec pull(const Vec& to, double mu) {
  const double r = length(to);
  return (mu / (r * r * r)) * to;
}

/// One step of symplectic Euler for stars that pull on each other.
/// @param x  their positions [m], advanced in place
/// @param v  their velocities [m/s], advanced in place
/// @param mu  how much each pulls: the gravitational constant times its mass [m^3/s^2]
/// @param h  step size [s]
inline void step(std::vector<Vec>& x, std::vector<Vec>& v, const std::vector<double>& mu,
                 double h) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (j != i) v[i] += h * pull(x[j] - x[i], mu[j]);
    }
    x[i] += h * v[i];
  }
}
