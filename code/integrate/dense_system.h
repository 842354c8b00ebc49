// SPDX-License-Identifier: MIT-0
/// @file
/// The linear system of an implicit step, dense: for a few unknowns.
///
/// @code
/// #include "backward_euler.h"
///
/// // Two masses, the first on a spring from the wall, the second on a spring from the first.
/// const Eigen::Matrix2d k = (Eigen::Matrix2d() << 200, -100, -100, 100).finished();
/// const auto pull = [&k](const Eigen::Vector2d& x, const Eigen::Vector2d&, double) {
///   return Eigen::Vector2d(-k * x);
/// };
/// const auto jacobian = [&k](const auto&, const auto&, double, auto&& add) {
///   for (int i = 0; i < 2; ++i) {
///     for (int j = 0; j < 2; ++j) add(i, j, -k(i, j), 0.0);
///   }
/// };
/// integrate::DenseSystem<decltype(jacobian), double, 2> system(jacobian);
/// Eigen::Vector2d x(0.1, 0), v(0, 0);
/// const bool solved = integrate::backward_euler(x, v, 0.0, 1 / 60.0, pull, system);
/// @endcode
#pragma once
#include <Eigen/LU>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace integrate {

/// A system whose matrix is stored whole: for a few unknowns, up to a hundred or so.
///
/// The matrix need not be symmetric.
/// @tparam Jacobian  callable `(x, v, t, add)` that calls `add(i, j, dadx, dadv)` for every entry
/// that is not zero: the derivative of acceleration i by position j [1/s^2] and by velocity j
/// [1/s]; i and j count from 0
/// @tparam Real  `double` or `float`
/// @tparam Size  the number of unknowns, where it is known when compiling
template <class Jacobian, class Real = double, int Size = Eigen::Dynamic>
class DenseSystem {
 public:
  using Vec = Eigen::Matrix<Real, Size, 1>;  ///< all unknowns

  /// Takes the Jacobian of the acceleration.
  explicit DenseSystem(Jacobian jacobian) : jacobian_(std::move(jacobian)) {}

  /// Solves (1 + p da/dx + q da/dv) y = change, and puts y into `change`.
  /// @returns  false if the matrix is singular, or it or the answer is not finite
  template <class Time>
  bool operator()(const Vec& x, const Vec& v, Time t, Real p, Real q, Vec& change) {
    matrix_.setIdentity(x.size(), x.size());
    jacobian_(x, v, t, [&](Eigen::Index i, Eigen::Index j, Real dadx, Real dadv) {
      matrix_(i, j) += p * dadx + q * dadv;
    });
    if (!finite(matrix_.data(), matrix_.size())) return false;
    solver_.compute(matrix_);
    if ((solver_.matrixLU().diagonal().array() == 0).any()) return false;
    change = solver_.solve(change).eval();
    return finite(change.data(), change.size());
  }

 private:
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
  Eigen::Matrix<Real, Size, Size> matrix_;
  Eigen::PartialPivLU<Eigen::Matrix<Real, Size, Size>> solver_;
};

}  // namespace integrate
