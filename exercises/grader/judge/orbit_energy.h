// SPDX-License-Identifier: MIT-0
/// @file
/// Orbits, and what their energy does.
#pragma once
#include <vector>

#include "harness/force.h"
#include "judge/path.h"
#include "judge/random.h"

namespace judge {

/// An ellipse of half axis 1 m, tilted in space, from its nearest point.
struct Orbit {
  double mu = 1;  ///< [m^3/s^2]
  double eccentricity = 0;
  Start start;

  static Orbit draw(Random& random, double eccentricity);
  double period() const;  ///< [s]
  harness::Force force() const { return {harness::Force::orbit, {mu}}; }
};

/// (E - E0) / |E0| at each state.
std::vector<double> energy_error(const Orbit& orbit, const Path& path);

/// The largest of them in size, of the part from `first` to `last` of the run; 0 to 1.
double largest(const std::vector<double>& errors, double first, double last);

}  // namespace judge
