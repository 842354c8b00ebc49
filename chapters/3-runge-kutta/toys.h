// SPDX-License-Identifier: MIT-0
/// @file
/// The scenes of chapter 3: the cast's, and the drone on an ellipse.
#pragma once
#include <limits>

#include "../cast.h"

inline constexpr double rocket_time = 6;  ///< how long the rocket is watched [s]

/// The rocket with an engine that never stops.
inline constexpr scenes::Rocket<> engine_on{.burn_time = std::numeric_limits<double>::infinity()};

/// The drone on an ellipse, pulled as by a sun, once round in eight seconds as before: it flies as
/// the shuttle does.
inline constexpr scenes::Orbit<> ellipse = shuttle;
