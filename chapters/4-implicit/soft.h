// SPDX-License-Identifier: MIT-0
/// @file
/// The damping that a step adds to a soft constraint.
#pragma once
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "../cast.h"
#include "measure/record.h"
#include "measure/stability.h"
#include "scenes/spring.h"
#include "soft_step.h"

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
