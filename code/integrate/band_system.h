// SPDX-License-Identifier: MIT-0
/// @file
/// The linear system of an implicit step, banded: for a chain or a rope.
///
/// @code
/// #include "backward_euler.h"
///
/// // A chain between two walls: each mass is pulled by both of its neighbours.
/// const auto pull = [](const Eigen::VectorXd& x, const Eigen::VectorXd&, double) {
///   Eigen::VectorXd a = -2e4 * x;
///   a.head(x.size() - 1) += 1e4 * x.tail(x.size() - 1);
///   a.tail(x.size() - 1) += 1e4 * x.head(x.size() - 1);
///   return a;
/// };
/// const auto jacobian = [](const Eigen::VectorXd& x, const auto&, double, auto&& add) {
///   for (int i = 0; i < x.size(); ++i) add(i, i, -2e4, 0.0);
///   for (int i = 1; i < x.size(); ++i) add(i, i - 1, 1e4, 0.0);
///   for (int i = 1; i < x.size(); ++i) add(i - 1, i, 1e4, 0.0);
/// };
/// integrate::BandSystem<1, decltype(jacobian)> system(jacobian);
/// Eigen::VectorXd x = Eigen::VectorXd::Unit(100, 50), v = Eigen::VectorXd::Zero(100);
/// const bool solved = integrate::backward_euler(x, v, 0.0, 1 / 60.0, pull, system);
/// @endcode
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace integrate {

/// A system whose unknowns have near neighbours only: a chain, a rope.
///
/// Elimination without pivoting, in a time that grows with the number of unknowns and no faster.
/// The matrix need not be symmetric; it must not need pivoting, and that of a chain of springs does
/// not.
/// @tparam Width  how far the neighbours are: 1 for a chain, 3 for a rope in a plane, 5 in space
/// @tparam Jacobian  callable `(x, v, t, add)` that calls `add(i, j, dadx, dadv)` for every entry
/// that is not zero: the derivative of acceleration i by position j [1/s^2] and by velocity j
/// [1/s]; i and j count from 0
/// @tparam Real  `double` or `float`
template <int Width, class Jacobian, class Real = double>
class BandSystem {
 public:
  using Vec = Eigen::Matrix<Real, Eigen::Dynamic, 1>;  ///< all unknowns

  /// Takes the Jacobian of the acceleration.
  explicit BandSystem(Jacobian jacobian) : jacobian_(std::move(jacobian)) {}

  /// Solves (1 + p da/dx + q da/dv) y = change, and puts y into `change`.
  /// @returns  false if an entry lies outside of the band, or a pivot is zero or not finite, or the
  /// answer is not finite
  template <class Time>
  bool operator()(const Vec& x, const Vec& v, Time t, Real p, Real q, Vec& change) {
    rows_.setZero(2 * Width + 1, x.size());
    bool inside = true;
    jacobian_(x, v, t, [&](Eigen::Index i, Eigen::Index j, Real dadx, Real dadv) {
      const bool close = std::abs(i - j) <= Width;
      inside = inside && close;
      if (close) rows_(Width + j - i, i) += p * dadx + q * dadv;
    });
    if (!inside) return false;
    eliminate(change);
    substitute(change);
    return finite(rows_.data(), rows_.size()) && finite(change.data(), change.size());
  }

 private:
  static_assert(Width > 0, "without neighbours there is nothing to solve");
  static constexpr std::size_t size = std::size_t(Width);  // for -Wsign-conversion

  // A row, divided by its pivot, when all to the left of the pivot has been eliminated.
  struct Row {
    Real right[size];
    Real y;
  };

  // The rows above are kept at hand: to wait for them to come back from memory doubles the time.
  void eliminate(Vec& y) {
    Row above[size] = {};  // the nearest first
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      Eigen::Matrix<Real, 2 * Width + 1, 1> row = rows_.col(i);
      row[Width] += Real(1);
      Real rest = y[i];
      for (int up = Width; up > 0; --up) {
        const Row& other = above[up - 1];
        const Real factor = row[Width - up];
        for (int n = 0; n < Width; ++n) row[Width - up + 1 + n] -= factor * other.right[n];
        rest -= factor * other.y;
      }
      for (int up = Width - 1; up > 0; --up) above[up] = above[up - 1];
      rows_(Width, i) = row[Width];
      const Real inverse = Real(1) / row[Width];
      for (int n = 0; n < Width; ++n) {
        above[0].right[n] = rows_(Width + 1 + n, i) = inverse * row[Width + 1 + n];
      }
      above[0].y = y[i] = inverse * rest;
    }
  }

  void substitute(Vec& y) const {
    Real below[size] = {};  // the nearest first
    for (Eigen::Index i = y.size() - 1; i >= 0; --i) {
      Real rest = y[i];
      for (int n = Width - 1; n >= 0; --n) rest -= rows_(Width + 1 + n, i) * below[n];
      for (int n = Width - 1; n > 0; --n) below[n] = below[n - 1];
      below[0] = y[i] = rest;
    }
  }

  // By their bits, since -ffast-math takes every number for finite: one more in an exponent of ones
  // carries over into the sign.
  static bool finite(const Real* numbers, Eigen::Index count) {
    using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
    static_assert(sizeof(Bits) == sizeof(Real), "Real must be double or float");
    constexpr Bits one = Bits(1) << (sizeof(Real) == 4 ? 23 : 52);
    constexpr Bits sign = ~(~Bits(0) >> 1);
    Bits carried = 0;
    for (Eigen::Index n = 0; n < count; ++n) {
      Bits bits;
      std::memcpy(&bits, numbers + n, sizeof bits);
      carried |= (bits & (sign - one)) + one;
    }
    return carried < sign;
  }

  Jacobian jacobian_;
  Eigen::Matrix<Real, 2 * Width + 1, Eigen::Dynamic> rows_;  // a column holds a row, but for the 1
};

}  // namespace integrate
