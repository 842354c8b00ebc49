// SPDX-License-Identifier: MIT-0
/// @file
/// Masses on a line with springs between them: the simplest stiff system.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "scenes/state.h"

namespace scenes {

/// Masses on a line, a spring between neighbours, the first one tied to a wall by a spring too:
/// m_i x_i'' = k (x_(i+1) - x_i) - k (x_i - x_(i-1)), and c for k with the velocities.
///
/// Linear; each mass knows its two neighbours, so that the Jacobian has three diagonals.
/// @tparam Real  `double` or `float`
/// @see L. Brillouin, Wave Propagation in Periodic Structures (1946), chapter 1
template <class Real = double>
struct Chain {
  using Vec = Eigen::Matrix<Real, Eigen::Dynamic, 1>;  ///< how far each is from its place [m]

  int count = 10;            ///< how many masses; at least one
  Real mass = 1;             ///< of each but the last [kg]
  Real tip = mass;           ///< of the last, at the free end [kg]
  Real k = 1;                ///< stiffness of each spring [N/m]
  Real c = 0;                ///< damping of each spring [N s/m]
  Real stretch = Real(0.1);  ///< of each spring at the start [m]

  /// The accelerations [m/s^2].
  /// @param x  positions [m]
  /// @param v  velocities [m/s]
  template <class Time>
  Vec operator()(const Vec& x, const Vec& v, Time) const {
    Vec a(count);
    Real before = k * x[0] + c * v[0];
    for (int i = 0; i + 1 < count; ++i) {
      const Real after = k * (x[i + 1] - x[i]) + c * (v[i + 1] - v[i]);
      a[i] = (after - before) / mass;
      before = after;
    }
    a[count - 1] = -before / tip;
    return a;
  }

  // [jacobian]
  /// Hands the derivatives of the acceleration on, for the implicit methods.
  ///
  /// They are symmetric only if all masses are equal.
  /// @param add  called as `add(i, j, dadx, dadv)`: row, column, by position [1/s^2], by velocity
  /// [1/s]
  template <class Time, class Add>
  void jacobian(const Vec&, const Vec&, Time, Add&& add) const {
    const Real by_position = k / mass, by_velocity = c / mass;
    const int last = count - 1;
    for (int i = 0; i < last; ++i) {
      if (i > 0) add(i, i - 1, by_position, by_velocity);
      add(i, i, -2 * by_position, -2 * by_velocity);
      add(i, i + 1, by_position, by_velocity);
    }
    if (last > 0) add(last, last - 1, k / tip, c / tip);
    add(last, last, -k / tip, -c / tip);
  }
  // [jacobian]

  /// The mass of each unknown [kg].
  Vec masses() const {
    Vec all = Vec::Constant(count, mass);
    all[count - 1] = tip;
    return all;
  }

  /// At rest, every spring stretched by as much: let go by a hand that pulled at the free end.
  State<Vec> start() const {
    return {Vec::LinSpaced(count, stretch, Real(count) * stretch), Vec::Zero(count)};
  }

  /// Energy; conserved without damping, and never growing with it [J].
  /// @param x  positions [m]
  /// @param v  velocities [m/s]
  Real energy(const Vec& x, const Vec& v) const {
    const Vec between = x.tail(count - 1) - x.head(count - 1);
    const Real springs = k * (x[0] * x[0] + between.squaredNorm());
    return (springs + masses().dot(v.cwiseProduct(v))) / Real(2);
  }

  /// Frequency of a mode, without damping and with all masses equal [rad/s].
  /// @param mode  from 1, the slowest, to `count`, the fastest; the limit for a long chain is
  /// 2 sqrt(k / m)
  Real frequency(int mode) const {
    const Real angle =
        Real(2 * mode - 1) * std::numbers::pi_v<Real> / (Real(2) * Real(2 * count + 1));
    return Real(2) * std::sqrt(k / mass) * std::sin(angle);
  }
};

}  // namespace scenes
