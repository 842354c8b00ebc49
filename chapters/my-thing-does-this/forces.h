// SPDX-License-Identifier: MIT-0
/// @file
/// Forces to copy, each as an acceleration.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

using Vec = Eigen::Vector3d;

// [buoyancy]
/// A box that floats upright: its bottom is at height z of calm water at 0.
/// @param density  of the box, over that of water
/// @returns  upwards, gravity included [m/s^2]
inline double buoyancy(double z, double height, double density) {
  const double under_water = std::clamp(-z / height, 0.0, 1.0);
  return 9.81 * (under_water / density - 1);
}
// [buoyancy]

// [thrust]
/// A rocket that burns so much a second [kg/s], which leaves it at `exhaust` [m/s] along its nose.
/// Less of it is left in each step: mass = mass - h * burn.
inline Vec thrust(const Vec& nose, double exhaust, double burn, double mass) {
  return exhaust * burn / mass * nose;
}
// [thrust]

// [magnet]
/// Draws a coin to a player, from far by an inverse square, and next to him by a spring.
/// @param way  from the coin to the player [m]
/// @param strongest  pull, at 0.7 of the softness [m/s^2]
/// @param softness  within which it gets weaker again [m]
inline Vec magnet(const Vec& way, double strongest, double softness) {
  const double square = way.squaredNorm() + softness * softness;
  return 2.598 * strongest * softness * softness / (square * std::sqrt(square)) * way;
}
// [magnet]

// [wind]
/// A step of what air carries along and slows down: drag by the speed past the air, divided.
/// @param a  of all other forces [m/s^2]
inline void blown(Vec& x, Vec& v, const Vec& a, const Vec& wind, double c, double h) {
  v = (v + h * (a + c * wind)) / (1 + h * c);
  x = x + h * v;
}
// [wind]

// [homing]
/// Steers a missile to where its target will be.
/// @param way  from the missile to the target [m]
/// @param speed  that it wants [m/s]
/// @param most  that its engine can do [m/s^2]
inline Vec homing(const Vec& way, const Vec& v, const Vec& v_target, double speed, double most) {
  const double time = way.norm() / speed;  // until it is there, more or less
  const Vec ahead = way + time * v_target;
  const Vec wanted = speed / std::max(ahead.norm(), 1e-9) * ahead;
  const Vec a = 4 * (wanted - v);  // with 37 % left of it in a quarter of a second
  return std::min(1.0, most / std::max(a.norm(), 1e-9)) * a;
}
// [homing]
