// SPDX-License-Identifier: MIT-0
/// @file
/// A rocket that rises straight up while its mass burns away: an acceleration that changes in time.
#pragma once
#include <algorithm>
#include <cmath>

#include "scenes/state.h"

namespace scenes {

/// A rocket that rises straight up: x'' = thrust / (mass - burn t) - g, and -g after burnout.
///
/// The acceleration depends on the time alone. It jumps at `burn_time`: a method keeps its order
/// only when a step ends there. Needs burn > 0 and burn * burn_time < mass, or the mass runs out.
/// There is neither air nor ground; with thrust < mass * g it starts by falling.
/// @tparam Real  `double` or `float`
/// @see K. E. Tsiolkovsky, The Exploration of Cosmic Space by Means of Reaction Devices (1903)
template <class Real = double>
struct Rocket {
  using Vec = Real;  ///< height [m], up

  Real thrust = 35;        ///< force of the engine [N]
  Real mass = 2;           ///< mass at the start, fuel included [kg]
  Real burn = Real(0.25);  ///< fuel burnt per second [kg/s]
  Real burn_time = 4;      ///< when the engine stops [s]
  Real g = Real(9.81);     ///< acceleration of gravity, downwards [m/s^2]

  // [acceleration]
  /// The acceleration [m/s^2]; the engine is off at `burn_time` itself.
  /// @param t  time since ignition [s]; before ignition, the engine burns too
  template <class Time>
  constexpr Vec operator()(const Vec&, const Vec&, Time t) const {
    if (t >= burn_time) return -g;
    return thrust / (mass - burn * static_cast<Real>(t)) - g;
  }
  // [acceleration]

  /// At rest, at height zero.
  constexpr State<Vec> start() const { return {Real(0), Real(0)}; }

  /// The state before and after burnout, by Tsiolkovsky's equation.
  /// @param t  time since ignition [s]
  State<Vec> exact(Real t) const {
    const Real burning = std::min(t, burn_time);
    const Real coasting = t - burning;
    const Real exhaust_speed = thrust / burn;
    const Real log_ratio = -std::log1p(-burn * burning / mass);
    const Real boost = exhaust_speed * log_ratio;
    const Real height = exhaust_speed * burning - (mass / burn - burning) * boost;
    return {height + boost * coasting - g * t * t / Real(2), boost - g * t};
  }
};

}  // namespace scenes
