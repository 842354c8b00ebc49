// SPDX-License-Identifier: MIT-0
#include "judge/orbit_energy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace judge {

Orbit Orbit::draw(Random& random, double eccentricity) {
  Orbit orbit{random.between(0.7, 1.5), eccentricity, {}};
  const double tilt = random.between(0.2, 1.2);
  const double nearest = 1 - eccentricity;
  const double speed = std::sqrt(orbit.mu * (1 + eccentricity) / nearest);
  orbit.start.x = {nearest, 0, 0};
  orbit.start.v = {0, speed * std::cos(tilt), speed * std::sin(tilt)};
  return orbit;
}

double Orbit::period() const {
  return 2 * std::numbers::pi / std::sqrt(mu);
}

std::vector<double> energy_error(const Orbit& orbit, const Path& path) {
  const auto energy = [&](const State& state) {
    return dot(state.v, state.v) / 2 - orbit.mu / length(state.x);
  };
  const double start = energy(path.states.front());
  std::vector<double> errors;
  for (const State& state : path.states)
    errors.push_back((energy(state) - start) / std::abs(start));
  return errors;
}

double largest(const std::vector<double>& errors, double first, double last) {
  const auto size = static_cast<double>(errors.size());
  double found = 0;
  for (auto n = static_cast<std::size_t>(first * size); n < static_cast<std::size_t>(last * size);
       ++n) {
    if (!std::isfinite(errors[n])) return INFINITY;
    found = std::max(found, std::abs(errors[n]));
  }
  return found;
}

}  // namespace judge
