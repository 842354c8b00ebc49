// SPDX-License-Identifier: MIT-0
/// @file
/// The drone of chapter 2, and the step it is moved by.
#pragma once
#include <numbers>

#include "scenes/circle.h"

// [drone]
inline constexpr scenes::Circle<> drone{.omega = 2 * std::numbers::pi / 8, .radius = 10};
inline constexpr double h = 1.0 / 60;
inline constexpr long turn = 480;
// [drone]
inline constexpr double fence = 12;  ///< how far from the tower it stands [m]
