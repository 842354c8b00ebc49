// SPDX-License-Identifier: MIT-0
/// @file
/// A soft constraint as engines have it in chapter 4, solved once in a step or twice.
#pragma once
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
