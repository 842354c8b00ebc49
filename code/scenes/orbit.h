// SPDX-License-Identifier: MIT-0
/// @file
/// A planet on an ellipse around its sun.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/state.h"

namespace scenes {

/// A planet around a sun that does not move, after Kepler: x'' = -mu x / |x|^3, in the plane.
///
/// The start is at the pericentre, where the planet is nearest to the sun and fastest. At the sun
/// itself the acceleration is not a number.
/// @tparam Real  `double` or `float`
/// @see Hairer, Lubich and Wanner, Geometric Numerical Integration (2006), section I.2.2
template <class Real = double>
struct Orbit {
  using Vec = Eigen::Matrix<Real, 2, 1>;  ///< a point of the plane, the sun at the origin

  Real eccentricity = Real(0.6);  ///< 0 is a circle; not negative, less than 1
  Real semi_major = 1;            ///< half the long axis [m]
  Real mu = 1;                    ///< gravitational constant times the mass of the sun [m^3/s^2]

  /// The acceleration [m/s^2].
  /// @param x  position [m]
  template <class Time>
  Vec operator()(const Vec& x, const Vec&, Time) const {
    const Real r = x.norm();
    return (-mu / (r * r * r)) * x;
  }

  /// Hands the derivatives of the acceleration on, for the implicit methods.
  /// @param x  position [m]
  /// @param add  called as `add(i, j, dadx, dadv)`: row, column, by position [1/s^2], by velocity
  /// [1/s]
  template <class Time, class Add>
  void jacobian(const Vec& x, const Vec&, Time, Add&& add) const {
    const Real r = x.norm();
    const Vec toward = x / r;
    const Eigen::Matrix<Real, 2, 2> tide =
        (mu / (r * r * r)) *
        (Real(3) * toward * toward.transpose() - Eigen::Matrix<Real, 2, 2>::Identity());
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) add(i, j, tide(i, j), Real(0));
    }
  }

  /// At the pericentre: on the first axis, on its way to the second.
  State<Vec> start() const { return at(Real(0)); }

  /// The state at any time, also before the start; right to rounding, but e near 1 costs digits.
  /// @param t  time since the start [s]
  State<Vec> exact(Real t) const {
    const Real turn = std::remainder(t, period());
    const Real anomaly = eccentric_anomaly(mean_motion() * std::abs(turn));
    return at(std::copysign(anomaly, turn));
  }

  /// Time of one turn [s].
  Real period() const { return Real(2) * std::numbers::pi_v<Real> / mean_motion(); }

  /// Energy per unit mass, which is conserved [J/kg].
  /// @param x  position [m]
  /// @param v  velocity [m/s]
  Real energy(const Vec& x, const Vec& v) const {
    return v.squaredNorm() / Real(2) - mu / x.norm();
  }

  /// Angular momentum per unit mass, which is conserved [m^2/s].
  /// @param x  position [m]
  /// @param v  velocity [m/s]
  Real angular_momentum(const Vec& x, const Vec& v) const { return x.x() * v.y() - x.y() * v.x(); }

 private:
  Real mean_motion() const { return std::sqrt(mu / semi_major) / semi_major; }

  // Kepler's equation E - e sin E = M for 0 <= M <= pi, by Newton's method. The first guess lies
  // above the root, where the left side is convex, so that every step goes down until rounding.
  Real eccentric_anomaly(Real mean) const {
    const Real e = eccentricity;
    Real guess = std::min(mean + e, std::numbers::pi_v<Real>);
    for (;;) {
      const Real miss = guess - e * std::sin(guess) - mean;
      const Real next = guess - miss / (Real(1) - e * std::cos(guess));
      if (!(next < guess)) return guess;
      guess = next;
    }
  }

  State<Vec> at(Real anomaly) const {
    const Real e = eccentricity;
    const Real flat = std::sqrt((Real(1) - e) * (Real(1) + e));
    const Real cosine = std::cos(anomaly);
    const Real sine = std::sin(anomaly);
    const Real speed = semi_major * mean_motion() / (Real(1) - e * cosine);
    return {semi_major * Vec{cosine - e, flat * sine}, speed * Vec{-sine, flat * cosine}};
  }
};

}  // namespace scenes
