// SPDX-License-Identifier: MIT-0
/// @file
/// The stiff bar that opens chapter 4, and the softer springs beside it.
#pragma once
#include <numbers>

#include "scenes/circle.h"
#include "scenes/spring.h"

inline constexpr double frame = 1.0 / 60;  ///< the step of the chapter [s]

/// The drone of chapter 2, ten metres from its tower.
inline constexpr scenes::Circle<> drone{.omega = 2 * std::numbers::pi / 8, .radius = 10};
inline constexpr long turn = 480;  ///< steps in a turn of the drone

// [bar]
/// Steel between a truck and its trailer: swings about a hundred times a second.
inline constexpr scenes::Spring<> bar{.omega = 600, .zeta = 0.1, .x0 = 0.001};
// [bar]

/// The suspension of a toy car, which swings about three times a second.
inline constexpr scenes::Spring<> suspension{.omega = 20, .zeta = 0.1, .x0 = 0.1};

/// An undamped spring by how often it swings [1/s].
constexpr scenes::Spring<> swinging(double times_a_second) {
  return {.omega = 2 * std::numbers::pi * times_a_second};
}

/// What one step of backward Euler leaves of the energy of an undamped spring.
constexpr double left_in_a_step(double homega) {
  return 1 / (1 + homega * homega);
}
