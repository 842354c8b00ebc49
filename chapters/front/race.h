// SPDX-License-Identifier: MIT-0
/// @file
/// A shuttle around a planet, followed by every method of the talks at one price.
#pragma once
#include <cmath>
#include <numbers>

#include "../cast.h"
#include "measure/evaluations.h"
#include "measure/run.h"

inline constexpr double price = 15;    ///< evaluations of the acceleration per second
inline constexpr int turns = 20;       ///< length of the race
inline constexpr double planet = 2;    ///< radius; who comes closer has crashed [m]
inline constexpr double picture = 23;  ///< out to the far corner of the figure [m]

/// How long a step may be that asks for the acceleration `rate` times a second [s].
template <class Step>
double affordable(const Step& step, double rate) {
  return double(measure::evaluations_per_step(step, race_shuttle, 0.01)) / rate;
}

/// Follows the shuttle until the race is over, or it has crashed.
/// @param step  a method
/// @param rate  evaluations per second
/// @param observe  called as `observe(t, s)`
template <class Step, class Observe>
void race(const Step& step, double rate, Observe&& observe) {
  const double h = affordable(step, rate);
  const auto start = race_shuttle.start();
  auto memory = measure::start(step, start, h, race_shuttle);
  auto s = start;
  observe(0.0, s);
  for (long n = 0; n < std::lround(turns * shuttle_turn / h) && s.x.norm() > planet; ++n) {
    measure::advance(step, memory, double(n) * h, h, race_shuttle);
    s = measure::to_state(step, memory, double(n + 1) * h, h, race_shuttle);
    observe(double(n + 1) * h, s);
  }
}

/// The ellipse on which a shuttle flies, on average over one turn.
struct Ellipse {
  double semi_major = 0;                                 ///< half of its length [m]
  Eigen::Vector2d to_nearest = Eigen::Vector2d::Zero();  ///< points at its nearest point

  /// The direction of its nearest point; 0 at the start [degrees].
  double direction() const {
    return std::atan2(to_nearest.y(), to_nearest.x()) * 180 / std::numbers::pi;
  }
};

/// The ellipse of one turn, the first being 0.
template <class Step>
Ellipse ellipse_of(const Step& step, int which) {
  const long steps = std::lround(shuttle_turn / affordable(step, price));
  Ellipse mean;
  long n = 0;
  race(step, price, [&](double, const auto& s) {
    if (n++ / steps != which) return;
    const double spin = race_shuttle.angular_momentum(s.x, s.v);
    mean.semi_major -= race_shuttle.mu / (2 * race_shuttle.energy(s.x, s.v)) / double(steps);
    mean.to_nearest +=
        spin / race_shuttle.mu * Eigen::Vector2d(s.v.y(), -s.v.x()) - s.x / s.x.norm();
  });
  return mean;
}
