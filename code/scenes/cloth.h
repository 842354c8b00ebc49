// SPDX-License-Identifier: MIT-0
/// @file
/// A square of cloth in space, held at two corners.
#pragma once
#include <Eigen/Core>
#include <numbers>

#include "scenes/net.h"
#include "scenes/state.h"

namespace scenes {

/// A square of cloth in space: a grid of equal masses, springs along its rows and columns and across
/// both diagonals of its cells; two corners of one edge are held.
///
/// Each mass knows its eight neighbours. Where neighbours meet, the acceleration is not a number.
/// @tparam Real  `double` or `float`
/// @see Link, for the springs; D. Baraff and A. Witkin, Large steps in cloth simulation, SIGGRAPH
/// (1998)
template <class Real = double>
struct Cloth {
  using Vec = Eigen::Matrix<Real, Eigen::Dynamic, 1>;  ///< three numbers a mass: right, up, to you

  int side = 10;           ///< how many masses along an edge; at least two
  Real width = 1;          ///< of an edge at rest [m]
  Real node_mass = Real(0.002);  ///< of each node [kg]
  Real k = 100;            ///< stiffness of each spring [N/m]
  Real c = 0;              ///< damping of each spring, along itself [N s/m]
  Real g = Real(9.81);     ///< acceleration of gravity, downwards [m/s^2]
};

}  // namespace scenes
