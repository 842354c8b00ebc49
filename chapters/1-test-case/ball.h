// SPDX-License-Identifier: MIT-0
/// @file
/// The thrown ball of chapter 1.
#pragma once
#include <Eigen/Core>

#include "scenes/linear_drag.h"

/// A ball thrown at ten metres a second across and ten up.
///
/// Drag in proportion to the speed acts on each coordinate by itself. So a throw is two falls, one
/// of them sideways and without gravity, and has an exact path.
struct Ball {
  using Vec = Eigen::Vector2d;

  scenes::LinearDrag<> across, up;

  /// @param c  drag per mass [1/s]; zero for no air
  explicit Ball(double c) : across{.c = c, .g = 0, .v0 = 10}, up{.c = c, .v0 = 10} {}

  /// The acceleration [m/s^2].
  Vec operator()(const Vec& x, const Vec& v, double t) const {
    return {across(x.x(), v.x(), t), up(x.y(), v.y(), t)};
  }
  scenes::State<Vec> start() const { return {Vec::Zero(), {across.v0, up.v0}}; }
  scenes::State<Vec> exact(double t) const {
    const auto [x, u] = across.exact(t);
    const auto [y, w] = up.exact(t);
    return {{x, y}, {u, w}};
  }
};

inline const Ball in_a_vacuum(0);
inline const Ball in_air(1);  // per second: a ball of paper
