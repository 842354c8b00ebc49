// SPDX-License-Identifier: MIT-0
/// @file
/// How far the shuttle's ellipse turns, and what stays as it is.
#pragma once
#include <cmath>
#include <numbers>

#include "measure/energy.h"
#include "measure/methods.h"
#include "measure/record.h"
#include "shadow.h"
#include "shuttle.h"

/// The direction in which the orbit through a state has its nearest point.
inline Eigen::Vector2d to_pericentre(const Eigen::Vector2d& x, const Eigen::Vector2d& v) {
  const double spin = shuttle.angular_momentum(x, v);
  return Eigen::Vector2d(spin / shuttle.mu * Eigen::Vector2d(v.y(), -v.x()) - x / x.norm())
      .normalized();
}

/// From one direction to another [rad].
inline double angle(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

/// How far the ellipse turns in one turn of the shuttle, on average over some of them [degrees].
template <class Step>
double turning(Step step, double h, int turns) {
  constexpr double once = 2 * std::numbers::pi;
  Eigen::Vector2d first = Eigen::Vector2d::Zero(), last = Eigen::Vector2d::Zero();
  auto s = shuttle.start();
  for (double flown = 0; flown < (turns + 1) * once;) {
    const Eigen::Vector2d direction = to_pericentre(s.x, s.v);
    if (flown < once) first += direction;
    if (flown >= turns * once) last += direction;
    const Eigen::Vector2d before = s.x;
    step(s.x, s.v, 0.0, h, shuttle);
    flown += angle(before, s.x);  // a turn may take longer than it should
  }
  return angle(first, last) * 180 / std::numbers::pi / turns;
}

/// How long a turn of the shuttle takes, from one farthest point to the next, on average over the
/// time of a thousand turns [s].
/// @param started  how long after its nearest point the shuttle sets out [s]
template <class Step>
double turn_takes(Step step, double h, double started = 0) {
  double first = 0, last = 0;
  long turns = -1;
  auto s = shuttle.exact(started);
  for (double t = 0; t < 1000 * shuttle_turn; t += h) {
    const double outwards = s.x.dot(s.v);
    step(s.x, s.v, 0.0, h, shuttle);
    const double afterwards = s.x.dot(s.v);
    if (outwards <= 0 || afterwards > 0) continue;
    last = t + h * outwards / (outwards - afterwards);
    if (++turns == 0) first = last;
  }
  return (last - first) / double(turns);
}

inline void orbit(measure::Record& record) {
  auto& table = record.table("turning", {{"t", "s"}, {"x", "m"}, {"y", "m"}});
  auto s = shuttle.start();
  measure::run(measure::symplectic_euler, shuttle, s, tick, 60 * 130,
               [&](double t, const auto& now) { table.add({t, now.x.x(), now.x.y()}); });
  record.number("turning-15", -turning(measure::symplectic_euler, tick, 60), 3, "°");
  const auto turns = [](double h) {
    return 1000 * shuttle_turn / turn_takes(measure::symplectic_euler, h);
  };
  record.number("turn-takes", turn_takes(measure::symplectic_euler, tick), 3, "s");
  record.number("turns-flown", turns(tick), 3);
  record.number("turns-flown-60", turns(tick / 4), 3);
  record.number("turns-flown-later",
                1000 * shuttle_turn / turn_takes(measure::symplectic_euler, tick, 1), 4);
  record.number("turns-turned", turns(tick) * -turning(measure::symplectic_euler, tick, 60) / 360,
                2);
  record.number("turning-60", -turning(measure::symplectic_euler, tick / 4, 60), 3, "°");
  const auto energy = [](auto& x, auto& v) { return shuttle.energy(x, v); };
  const auto sway = [&](auto invariant) {
    return 100 *
           measure::drift(measure::symplectic_euler, shuttle, frame, 60 * 480, invariant).largest;
  };
  record.number("shuttle-energy", sway(energy), 2, "%");
  record.number("shuttle-shadow", sway(shadow_energy(shuttle, frame)), 2, "%");
}
