// SPDX-License-Identifier: MIT-0
/// @file
/// Three ways to start position Verlet.
#pragma once
#include "measure/methods.h"
#include "measure/order.h"

/// Position Verlet with another start: how long ago the thing was where it is now does not matter.
struct FromRest : measure::StormerVerlet {
  template <class V, class Real, class Scene>
  static std::array<V, 2> start(const scenes::State<V>& s, Real, const Scene&) {
    return {s.x, s.x};
  }
};

/// Position Verlet, started with the velocity and without the acceleration.
struct ByVelocity : measure::StormerVerlet {
  template <class V, class Real, class Scene>
  static std::array<V, 2> start(const scenes::State<V>& s, Real h, const Scene&) {
    return {s.x, s.x + (-h) * s.v};
  }
};

inline constexpr FromRest from_rest;
inline constexpr ByVelocity by_velocity;
