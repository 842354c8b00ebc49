// SPDX-License-Identifier: MIT-0
/// @file
/// How often a step is taken where speed is set against accuracy, here and in the page.
#pragma once
#include <array>
#include <cstddef>

inline constexpr std::size_t one_body = 1;                ///< each step waits for the last
inline constexpr std::size_t in_a_loop = 512;             ///< throughput
inline constexpr std::size_t beyond_the_cache = 100'000;  ///< memory

/// Steps in a frame that the page tries.
inline constexpr std::array<int, 7> tried_in_a_frame{1, 2, 3, 4, 6, 8, 12};

/// A step so short that nothing explodes while it is timed [s].
inline constexpr double brief_step = 1e-6;
