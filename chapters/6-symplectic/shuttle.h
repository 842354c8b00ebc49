// SPDX-License-Identifier: MIT-0
/// @file
/// A shuttle on an ellipse, on a server that ticks fifteen times a second.
#pragma once
#include <numbers>

#include "scenes/orbit.h"

inline constexpr double tick = 1.0 / 15;   ///< [s]
inline constexpr double shuttle_turn = 8;  ///< time of a turn [s]
inline constexpr scenes::Orbit<> shuttle{
    .eccentricity = 0.6,
    .semi_major = 10,
    .mu = 1000 * (2 * std::numbers::pi / shuttle_turn) * (2 * std::numbers::pi / shuttle_turn)};
