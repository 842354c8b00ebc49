// SPDX-License-Identifier: MIT-0
/// @file
/// A soft constraint as engines have it in chapter 4, and the damping that a step adds to it.
#pragma once
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "../cast.h"
#include "measure/record.h"
#include "measure/stability.h"
#include "scenes/spring.h"

/// One step of a soft constraint on a single body.
/// @param stretch  how far the constraint is from being met [m]
/// @param v  its rate [m/s]
inline void soft_constraint(double& stretch, double& v, double h, double omega, double zeta) {
  // [soft]
  const double damping_and_step = 2 * zeta + h * omega;
  const double stiff = h * omega * damping_and_step;
  const double bias_rate = omega / damping_and_step;
  const double mass_scale = stiff / (1 + stiff);
  v = v - mass_scale * (v + bias_rate * stretch);
  stretch = stretch + h * v;
  // [soft]
}

/// soft_constraint() as a method on a spring.
inline constexpr auto soft_step = [](double& x, double& v, double, double h,
                                     const scenes::Spring<>& spring) {
  soft_constraint(x, v, h, spring.omega, spring.zeta);
};

/// soft_constraint() as Box2D 3 takes it: solved once before the body moves and once after, in its
/// new place. What the first solve did is kept and taken back first, so the second begins with the
/// velocity of the start.
inline constexpr auto soft_step_twice = [](double& x, double& v, double, double h,
                                           const scenes::Spring<>& spring) {
  double rate = v;
  soft_constraint(x, rate, h, spring.omega, spring.zeta);
  double stretch = x;
  soft_constraint(stretch, v, h, spring.omega, spring.zeta);
};

/// Frequency and damping ratio of the spring that a method really moves.
/// @returns  those with which the exact motion would take the same step; {rad/s, 1}
template <class Step>
scenes::Spring<> effective_spring(Step step, const scenes::Spring<>& spring, double h) {
  const std::complex<double> factor =
      measure::eigenvalues(measure::step_matrix(step, spring, h))[0];
  const std::complex<double> rate = std::log(factor) / h;
  return {.omega = std::abs(rate), .zeta = -rate.real() / std::abs(rate)};
}

/// Records the damping ratios that soft constraints really have.
inline void soft_damping(measure::Record& record) {
  auto& soft = record.table("soft", {{"hω"}, {"asked 0"}, {"asked 0.2"}, {"asked 0.7"}});
  for (int tenths = 1; tenths <= 30; ++tenths) {
    const auto got = [&](double zeta) {
      return effective_spring(soft_step, {.omega = tenths / 10.0 / frame, .zeta = zeta}, frame)
          .zeta;
    };
    soft.add({tenths / 10.0, got(0), got(0.2), got(0.7)});
  }
  for (const int rate : {30, 60, 240}) {
    const auto got = effective_spring(soft_step, swinging(5), 1.0 / rate);
    record.number("soft-" + std::to_string(rate), got.zeta, 2);
    if (rate == 240) continue;  // too short a step to tell
    const double swings = got.omega * std::sqrt(1 - got.zeta * got.zeta) / (2 * std::numbers::pi);
    record.number("soft-swings-" + std::to_string(rate), swings, 2);
  }
  record.number("box2d-60", effective_spring(soft_step_twice, swinging(5), frame / 4).zeta, 2);
  record.number("box2d-60-whole", effective_spring(soft_step_twice, swinging(5), frame).zeta, 2);
}
