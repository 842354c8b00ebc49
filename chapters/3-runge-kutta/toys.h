// SPDX-License-Identifier: MIT-0
/// @file
/// The scenes of chapter 3: those of chapter 2, and a rocket that burns out between two steps.
#pragma once
#include "../2-euler/drone.h"
#include "scenes/orbit.h"
#include "scenes/quadratic_drag.h"
#include "scenes/rocket.h"
#include "scenes/spring.h"

/// The suspension of a toy car, which swings about three times a second.
inline constexpr scenes::Spring<> suspension{.omega = 20, .zeta = 0.1, .x0 = 0.1};

/// A door with a strong closer.
inline constexpr scenes::Spring<> door{.omega = 10, .zeta = 5, .x0 = 1};

/// Burns out between two steps at every rate that divides a second.
inline constexpr scenes::Rocket<> rocket{.burn_time = 3.7103};
inline constexpr double rocket_time = 6;  ///< how long it is watched [s]

/// The drone on an ellipse, pulled as by a sun, once round in eight seconds as before.
inline const scenes::Orbit<> ellipse{
    .eccentricity = 0.6, .semi_major = 10, .mu = 1000 * drone.omega * drone.omega};

/// An undamped spring by how often it swings [1/s].
constexpr scenes::Spring<> swinging(double times_a_second) {
  return {.omega = 2 * std::numbers::pi * times_a_second};
}

/// A parachute that opens at once, made for 5 m/s.
inline constexpr scenes::QuadraticDrag<> parachute{.k = 9.81 / (5 * 5)};
