// SPDX-License-Identifier: MIT-0
/// @file
/// The linear system of an implicit step, banded: for a chain or a rope.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <utility>

namespace integrate {

// [system]
/// A system whose unknowns have near neighbours only: a chain, a rope.
///
/// Elimination without pivoting, in a time that grows with the number of unknowns and no faster.
/// The matrix need not be symmetric; it must not need pivoting, and that of a chain of springs does
/// not.
/// @tparam Width  how far the neighbours are: 1 for a chain, 5 for a rope in three dimensions
/// @tparam Jacobian  callable `(x, v, t, add)` that calls `add(i, j, dadx, dadv)` for every entry
/// that is not zero: the derivative of acceleration i by position j [1/s^2] and by velocity j [1/s]
/// @tparam Real  `double` or `float`
template <int Width, class Jacobian, class Real = double>
class BandSystem {
 public:
  using Vec = Eigen::Matrix<Real, Eigen::Dynamic, 1>;  ///< all unknowns

  /// Takes the Jacobian of the acceleration.
  explicit BandSystem(Jacobian jacobian) : jacobian_(std::move(jacobian)) {}

  /// Solves (1 + p da/dx + q da/dv) y = change, and puts y into `change`.
  /// @returns  false if an entry lies outside of the band, or a pivot is zero or not finite
  template <class Time>
  bool operator()(const Vec& x, const Vec& v, Time t, Real p, Real q, Vec& change) {
    rows_.setZero(2 * Width + 1, x.size());
    rows_.row(Width).setOnes();
    bool inside = true;
    jacobian_(x, v, t, [&](Eigen::Index i, Eigen::Index j, Real dadx, Real dadv) {
      const bool near = std::abs(i - j) <= Width;
      inside = inside && near;
      if (near) rows_(Width + j - i, i) += p * dadx + q * dadv;
    });
    if (!inside) return false;
    eliminate(change);
    return change.allFinite();
  }

 private:
  void eliminate(Vec& y) {
    const Eigen::Index n = y.size();
    for (Eigen::Index i = 0; i < n; ++i) {
      const Real inverse = Real(1) / rows_(Width, i);
      rows_(Width, i) = inverse;
      for (int below = 1; below <= Width && i + below < n; ++below) {
        const Real factor = rows_(Width - below, i + below) * inverse;
        for (int right = 1; right <= Width; ++right) {
          rows_(Width - below + right, i + below) -= factor * rows_(Width + right, i);
        }
        y[i + below] -= factor * y[i];
      }
    }
    for (Eigen::Index i = n - 1; i >= 0; --i) {
      for (int right = 1; right <= Width && i + right < n; ++right) {
        y[i] -= rows_(Width + right, i) * y[i + right];
      }
      y[i] *= rows_(Width, i);
    }
  }

  Jacobian jacobian_;
  Eigen::Matrix<Real, 2 * Width + 1, Eigen::Dynamic> rows_;  // a column holds a row of the band
};
// [system]

}  // namespace integrate
