// SPDX-License-Identifier: MIT-0
/// @file
/// The scenes of chapter 5: those of the chapters before, and the step they are moved by.
#pragma once
#include <numbers>

#include "scenes/circle.h"
#include "scenes/linear_drag.h"
#include "scenes/projectile.h"
#include "scenes/rope.h"
#include "scenes/spring.h"

inline constexpr double frame = 1.0 / 60;  ///< [s]

/// The drone of chapter 2: once round in eight seconds.
inline constexpr scenes::Circle<> drone{.omega = 2 * std::numbers::pi / 8, .radius = 10};
inline constexpr long turn = 480;  ///< steps

/// Something that swings once a second, begun from rest.
inline constexpr scenes::Spring<> swing{.omega = 2 * std::numbers::pi, .x0 = 1};

/// The leaf of chapter 1.
inline constexpr scenes::LinearDrag<> leaf{.c = 2};

/// The jump of chapter 1.
inline const scenes::Projectile<> jump{.start_velocity = {0, 5}};

/// Two metres of rope in twenty springs, so stiff that its own weight stretches it by a hundredth.
inline const scenes::Rope<> springs{
    .count = 21, .length = 2, .mass = 0.01, .k = 210 * 0.01 * 9.81 / 0.02};

/// What is left after a second of a velocity of one, braked as in 2001.
inline double braked(int rate) {
  // [factor]
  double x = 0, x_previous = -1.0 / rate;
  for (int n = 0; n < rate; ++n) {
    const double x_next = 1.99 * x - 0.99 * x_previous;
    x_previous = x;
    x = x_next;
  }
  // [factor]
  return rate * (x - x_previous);
}
