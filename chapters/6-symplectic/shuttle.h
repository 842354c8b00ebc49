// SPDX-License-Identifier: MIT-0
/// @file
/// The shuttle on a server that ticks fifteen times a second.
#pragma once
#include "../cast.h"

inline constexpr double tick = 1.0 / 15;  ///< [s]
