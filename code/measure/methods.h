// SPDX-License-Identifier: MIT-0
/// @file
/// The methods of the book as objects that can be handed to run() and to the other measurements.
#pragma once
#include "integrate/constant_acceleration.h"
#include "integrate/euler.h"
#include "integrate/heun.h"
#include "integrate/midpoint.h"
#include "integrate/predicted_euler.h"
#include "integrate/rk4.h"
#include "integrate/symplectic_euler.h"

/// What is asked of a method on a scene: errors, orders, energies, limits and costs.
namespace measure {

/// integrate::euler as an object that can be handed on.
inline constexpr auto euler = [](auto& x, auto& v, auto t, auto h, auto&& acceleration) {
  integrate::euler(x, v, t, h, acceleration);
};

/// integrate::constant_acceleration as an object that can be handed on.
inline constexpr auto constant_acceleration = [](auto& x, auto& v, auto t, auto h,
                                                 auto&& acceleration) {
  integrate::constant_acceleration(x, v, t, h, acceleration);
};

/// integrate::symplectic_euler as an object that can be handed on.
inline constexpr auto symplectic_euler = [](auto& x, auto& v, auto t, auto h, auto&& acceleration) {
  integrate::symplectic_euler(x, v, t, h, acceleration);
};

/// integrate::symplectic_euler_position_first as an object that can be handed on.
inline constexpr auto symplectic_euler_position_first = [](auto& x, auto& v, auto t, auto h,
                                                           auto&& acceleration) {
  integrate::symplectic_euler_position_first(x, v, t, h, acceleration);
};

/// integrate::midpoint as an object that can be handed on.
inline constexpr auto midpoint = [](auto& x, auto& v, auto t, auto h, auto&& acceleration) {
  integrate::midpoint(x, v, t, h, acceleration);
};

/// integrate::heun as an object that can be handed on.
inline constexpr auto heun = [](auto& x, auto& v, auto t, auto h, auto&& acceleration) {
  integrate::heun(x, v, t, h, acceleration);
};

/// integrate::rk4 as an object that can be handed on.
inline constexpr auto rk4 = [](auto& x, auto& v, auto t, auto h, auto&& acceleration) {
  integrate::rk4(x, v, t, h, acceleration);
};

/// integrate::predicted_euler with a given number of corrections, as an object that can be handed
/// on.
template <int Corrections = 1>
inline constexpr auto predicted_euler = [](auto& x, auto& v, auto t, auto h, auto&& acceleration) {
  integrate::predicted_euler(x, v, t, h, acceleration, Corrections);
};

}  // namespace measure
