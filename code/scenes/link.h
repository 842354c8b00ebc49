// SPDX-License-Identifier: MIT-0
/// @file
/// A spring between two points of space.
#pragma once
#include <Eigen/Core>
#include <algorithm>

namespace scenes {

/// A spring between two points of space, with damping along itself.
///
/// Where the two points meet, its direction and all that follows from it is not a number.
/// @tparam Real  `double` or `float`
/// @see D. Baraff and A. Witkin, Large steps in cloth simulation, SIGGRAPH (1998)
template <class Real = double>
struct Link {
  using Vec3 = Eigen::Matrix<Real, 3, 1>;   ///< a vector of space
  using Block = Eigen::Matrix<Real, 3, 3>;  ///< a derivative of one by another; always symmetric

  Real length = 1;  ///< at rest [m]
  Real k = 1;       ///< stiffness [N/m]
  Real c = 0;       ///< damping [N s/m]

  /// How the first point is pulled towards the second [N]; the second feels the opposite.
  /// @param d  from the first point to the second [m]
  /// @param w  velocity of the second point, seen from the first [m/s]
  Vec3 pull(const Vec3& d, const Vec3& w) const {
    const Real r = d.norm();
    const Real tension = k * (r - length) + c * d.dot(w) / r;
    return (tension / r) * d;
  }

  /// The derivative of the pull by d [N/m], without two parts that would cost the matrix of an
  /// implicit step its symmetry or its positive definiteness: the one of the damping, and that
  /// across a compressed spring, which pushes aside what is already beside it.
  /// @param d  from the first point to the second [m]
  /// @see K.-J. Choi and H.-S. Ko, Stable but responsive cloth, SIGGRAPH (2002)
  Block stiffness(const Vec3& d) const {
    const Real r = d.norm();
    const Vec3 along = d / r;
    const Real across = k * std::max(Real(0), Real(1) - length / r);
    return (k - across) * Block(along * along.transpose()) + across * Block::Identity();
  }

  /// The derivative of the pull by w [N s/m].
  /// @param d  from the first point to the second [m]
  Block damping(const Vec3& d) const {
    const Vec3 along = d / d.norm();
    return c * Block(along * along.transpose());
  }

  /// The energy stored in the spring [J].
  /// @param d  from the first point to the second [m]
  Real energy(const Vec3& d) const {
    const Real stretch = d.norm() - length;
    return k * stretch * stretch / Real(2);
  }
};

}  // namespace scenes
