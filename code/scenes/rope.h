// SPDX-License-Identifier: MIT-0
/// @file
/// A rope in space: masses one after the other, with springs between them.
#pragma once
#include <Eigen/Core>

#include "scenes/net.h"
#include "scenes/state.h"

namespace scenes {

/// A rope in space, held at its first mass, at its last, at both or at neither.
///
/// Each mass knows its two neighbours, so that no entry of the Jacobian is farther than 5 from the
/// diagonal. Where neighbours meet, the acceleration is not a number.
/// @tparam Real  `double` or `float`
/// @see Link, for the springs
template <class Real = double>
struct Rope {
  using Vec = Eigen::Matrix<Real, Eigen::Dynamic, 1>;  ///< three numbers a mass: right, up, to you

  int count = 20;          ///< how many masses; at least two
  Real length = 2;         ///< of the rope at rest [m]
  Real mass = Real(0.01);  ///< of each but the last [kg]
  Real tip = mass;         ///< of the last [kg]
  Real k = 1000;           ///< stiffness of each spring [N/m]
  Real c = 0;              ///< damping of each spring, along itself [N s/m]
  Real g = Real(9.81);     ///< acceleration of gravity, downwards [m/s^2]
  bool first_held = true;  ///< whether the first mass keeps its velocity, at the start none
  bool last_held = false;  ///< whether the last one does

  /// The accelerations [m/s^2].
  /// @param x  positions [m]
  /// @param v  velocities [m/s]
  template <class Time>
  Vec operator()(const Vec& x, const Vec& v, Time) const {
    return net_acceleration(*this, x, v);
  }

  /// Hands the derivatives of the acceleration on, for the implicit methods; see net_jacobian().
  /// @param x  positions [m]
  /// @param add  called as `add(i, j, dadx, dadv)`: row, column, by position [1/s^2], by velocity
  /// [1/s]
  template <class Time, class Add>
  void jacobian(const Vec& x, const Vec&, Time, Add&& add) const {
    net_jacobian(*this, x, add);
  }

  /// At rest and straight, the first mass at the origin and the last to the right of it.
  State<Vec> start() const {
    Vec x = Vec::Zero(3 * count);
    for (int i = 0; i < count; ++i) x[3 * i] = Real(i) * spacing();
    return {x, Vec::Zero(3 * count)};
  }

  /// Energy; conserved without damping, and never growing with it [J].
  /// @param x  positions [m]
  /// @param v  velocities [m/s]
  Real energy(const Vec& x, const Vec& v) const { return net_energy(*this, x, v); }

  /// The mass of each unknown [kg].
  Vec masses() const {
    Vec all = Vec::Constant(3 * count, mass);
    all.template tail<3>().setConstant(tip);
    return all;
  }

  /// How many masses there are.
  int nodes() const { return count; }

  /// One of the masses [kg].
  Real mass_of(int i) const { return i + 1 < count ? mass : tip; }

  /// True of a mass that keeps the velocity that it has, which is none at the start.
  bool held(int i) const { return i == 0 ? first_held : i + 1 == count && last_held; }

  /// Calls `visit(i, j, link)` for each spring.
  template <class Visit>
  void for_each_link(Visit&& visit) const {
    const Link<Real> link{spacing(), k, c};
    for (int i = 0; i + 1 < count; ++i) visit(i, i + 1, link);
  }

 private:
  Real spacing() const { return length / Real(count - 1); }
};

}  // namespace scenes
