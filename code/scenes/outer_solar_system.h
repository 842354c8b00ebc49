// SPDX-License-Identifier: MIT-0
/// @file
/// The sun and the five outer bodies, with published start data.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string_view>

#include "scenes/state.h"

namespace scenes {

/// The sun and the five outer bodies, each pulling at every other after Newton.
///
/// Units: astronomical units, days, solar masses. The mass of the inner planets is added to the
/// sun's. The sun starts at rest, so the whole drifts. Where two bodies meet, the acceleration is
/// not a number.
/// @tparam Real  `double` or `float`
/// @see Hairer, Lubich and Wanner, Geometric Numerical Integration (2006), section I.2.4
template <class Real = double>
struct OuterSolarSystem {
  static constexpr int bodies = 6;             ///< how many
  using Vec = Eigen::Matrix<Real, 3, bodies>;  ///< one column for each body
  using Vec3 = Eigen::Matrix<Real, 3, 1>;      ///< a vector of space

  /// Gravitational constant [AU^3 / (solar mass day^2)].
  static constexpr Real G = Real(2.95912208286e-4);

  /// Name of each body.
  static constexpr std::string_view names[bodies] = {"Sun",    "Jupiter", "Saturn",
                                                     "Uranus", "Neptune", "Pluto"};

  /// Mass of each body [solar masses].
  static constexpr Real masses[bodies] = {Real(1.00000597682),      Real(0.000954786104043),
                                          Real(0.000285583733151),  Real(0.0000437273164546),
                                          Real(0.0000517759138449), Real(7.6923076923076923e-9)};

  /// The accelerations [AU/day^2].
  /// @param x  positions [AU]
  template <class Time>
  Vec operator()(const Vec& x, const Vec&, Time) const {
    Vec a = Vec::Zero();
    for (int i = 0; i < bodies; ++i) {
      for (int j = 0; j < i; ++j) {
        const Vec3 d = x.col(j) - x.col(i);
        const Real r = d.norm();
        const Vec3 pull = (G / (r * r * r)) * d;
        a.col(i) += masses[j] * pull;
        a.col(j) -= masses[i] * pull;
      }
    }
    return a;
  }

  /// The published positions [AU] and velocities [AU/day].
  State<Vec> start() const {
    using Rows = Eigen::Matrix<double, bodies, 3>;
    const Rows x{{0, 0, 0},
                 {-3.5023653, -3.8169847, -1.5507963},
                 {9.0755314, -3.0458353, -1.6483708},
                 {8.3101420, -16.2901086, -7.2521278},
                 {11.4707666, -25.7294829, -10.8169456},
                 {-15.5387357, -25.2225594, -3.1902382}};
    const Rows v{{0, 0, 0},
                 {0.00565429, -0.00412490, -0.00190589},
                 {0.00168318, 0.00483525, 0.00192462},
                 {0.00354178, 0.00137102, 0.00055029},
                 {0.00288930, 0.00114527, 0.00039677},
                 {0.00276725, -0.00170702, -0.00136504}};
    return {x.transpose().template cast<Real>(), v.transpose().template cast<Real>()};
  }

  /// Total energy, which is conserved [solar masses AU^2/day^2].
  /// @param x  positions [AU]
  /// @param v  velocities [AU/day]
  Real energy(const Vec& x, const Vec& v) const {
    Real sum = 0;
    for (int i = 0; i < bodies; ++i) {
      sum += masses[i] * v.col(i).squaredNorm() / Real(2);
      for (int j = 0; j < i; ++j) sum -= G * masses[i] * masses[j] / (x.col(j) - x.col(i)).norm();
    }
    return sum;
  }

  /// Total momentum, which is conserved [solar masses AU/day].
  /// @param v  velocities [AU/day]
  Vec3 momentum(const Vec& v) const {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < bodies; ++i) sum += masses[i] * v.col(i);
    return sum;
  }

  /// Total angular momentum about the origin, which is conserved [solar masses AU^2/day].
  /// @param x  positions [AU]
  /// @param v  velocities [AU/day]
  Vec3 angular_momentum(const Vec& x, const Vec& v) const {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < bodies; ++i) {
      const Vec3 r = x.col(i);
      const Vec3 p = masses[i] * v.col(i);
      sum += r.cross(p);
    }
    return sum;
  }
};

}  // namespace scenes
