// SPDX-License-Identifier: MIT-0
/// @file
/// A square of cloth in space, held at two corners.
#pragma once
#include <Eigen/Core>
#include <numbers>

#include "scenes/net.h"
#include "scenes/state.h"

namespace scenes {

/// A square of cloth in space: a grid of equal masses, springs along its rows and columns and
/// across both diagonals of its cells, two corners of one edge held.
///
/// Each mass knows its eight neighbours. Where neighbours meet, the acceleration is not a number.
/// @tparam Real  `double` or `float`
/// @see D. Baraff and A. Witkin, Large steps in cloth simulation, SIGGRAPH (1998)
template <class Real = double>
struct Cloth {
  using Vec = Eigen::Matrix<Real, Eigen::Dynamic, 1>;  ///< three numbers a mass: right, up, to you

  int side = 10;            ///< how many masses along an edge; at least two
  Real width = 1;           ///< of an edge at rest [m]
  Real mass = Real(0.002);  ///< of each [kg]
  Real k = 100;             ///< stiffness of each spring [N/m]
  Real c = 0;               ///< damping of each spring, along itself [N s/m]
  Real g = Real(9.81);      ///< acceleration of gravity, downwards [m/s^2]

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

  /// At rest, spread out flat at height zero, the held edge at the back.
  State<Vec> start() const {
    Vec x(3 * nodes());
    const Real spacing = width / Real(side - 1);
    for (int row = 0, n = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column, n += 3) {
        x.template segment<3>(n) << Real(column) * spacing, Real(0), Real(row) * spacing;
      }
    }
    return {x, Vec::Zero(x.size())};
  }

  /// Energy; conserved without damping, and never growing with it [J].
  /// @param x  positions [m]
  /// @param v  velocities [m/s]
  Real energy(const Vec& x, const Vec& v) const { return net_energy(*this, x, v); }

  /// How many masses there are.
  int nodes() const { return side * side; }

  /// One of the masses [kg].
  Real mass_of(int) const { return mass; }

  /// True of a mass that keeps the velocity that it has, which is none at the start.
  bool held(int i) const { return i == 0 || i == side - 1; }

  /// Calls `visit(i, j, link)` for each spring.
  template <class Visit>
  void for_each_link(Visit&& visit) const {
    const Real spacing = width / Real(side - 1);
    const Link<Real> edge{spacing, k, c};
    const Link<Real> diagonal{spacing * std::numbers::sqrt2_v<Real>, k, c};
    const struct {
      int right, down;
      Link<Real> link;
    } neighbours[] = {{1, 0, edge}, {0, 1, edge}, {1, 1, diagonal}, {-1, 1, diagonal}};
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) {
        for (const auto& [right, down, link] : neighbours) {
          const int there = column + right, below = row + down;
          if (there < 0 || there == side || below == side) continue;
          visit(row * side + column, below * side + there, link);
        }
      }
    }
  }
};

}  // namespace scenes
