// SPDX-License-Identifier: MIT-0
/// @file
/// What single precision costs a method.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "measure/many_starts.h"
#include "measure/run.h"
#include "scenes/spring.h"

/// Position Verlet that keeps its last distance in place of its last place.
struct DistanceKept {
  template <class Vec, class Real, class Scene>
  std::array<Vec, 2> start(const scenes::State<Vec>& s, Real h, const Scene& scene) const {
    return {s.x, h * s.v - (h * h / 2) * scene(s.x, s.v, Real(0))};
  }

  template <class Kept, class Real, class Scene>
  void step(Kept& kept, Real t, Real h, const Scene& scene) const {
    auto& [x, d] = kept;
    d = d + h * h * scene(x, d / h, t);
    x = x + d;
  }

  template <class Kept, class Real, class Scene>
  scenes::State<typename Kept::value_type> state_of(const Kept& kept, Real, Real h,
                                                    const Scene&) const {
    return {kept[0], kept[1] / h};
  }
};

/// How far two runs of a swing, in single and in double precision, part in ten seconds [m].
/// @param angle  of its swing at which it starts [rad]
template <class Step>
double lost_digits(Step step, double angle) {
  const float omega = 6.28f;
  const scenes::Spring<float> coarse{
      .omega = omega, .x0 = float(std::cos(angle)), .v0 = float(-double(omega) * std::sin(angle))};
  const scenes::Spring<> fine{.omega = omega, .x0 = coarse.x0, .v0 = coarse.v0};
  constexpr float h = 1 / 240.0f;
  std::vector<double> places;
  auto s = fine.start();
  measure::run(step, fine, s, double(h), 2400,
               [&](double, const auto& now) { places.push_back(now.x); });
  double most = 0;
  auto single = coarse.start();
  std::size_t n = 0;
  measure::run(step, coarse, single, h, 2400, [&](float, const auto& now) {
    most = std::max(most, std::abs(double(now.x) - places[n++]));
  });
  return most;
}

inline constexpr int swings_tried = 1000;  ///< each from another angle

/// How far they part, by the median of many starts [m].
template <class Step>
double lost_digits(Step step) {
  return measure::median(
      measure::all_around(swings_tried, [&](double angle) { return lost_digits(step, angle); }));
}
