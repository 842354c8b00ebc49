// SPDX-License-Identifier: MIT-0
/// @file
/// A body that spins freely, and where it exactly goes.
#pragma once
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "scenes/state.h"

namespace scenes {

/// A body without a torque, seen from itself: I w' = -w x (I w).
///
/// Its angular velocity w is what the methods call v; what they call x is not used. The exact
/// solution goes by Jacobi's elliptic functions. It needs three moments that are not all the same,
/// and neither a spin about one axis alone nor one that takes for ever to turn over.
/// @see L. D. Landau and E. M. Lifshitz, Mechanics (1976), section 37
struct EulerTop {
  using Real = long double;                  ///< more digits than what is compared with it
  using Vec = Eigen::Matrix<Real, 3, 1>;     ///< along the body's or the world's axes
  using Matrix = Eigen::Matrix<Real, 3, 3>;  ///< a turn

  Vec inertia{1, 2, 3};   ///< about the body's own axes [kg m^2]
  Vec w{0.2L, 20, 0.2L};  ///< angular velocity at the start, in the body's axes [rad/s]

  /// The angular acceleration in the body's axes [rad/s^2].
  template <class Time>
  Vec operator()(const Vec&, const Vec& now, Time) const {
    return -now.cross(inertia.cwiseProduct(now)).cwiseQuotient(inertia);
  }

  /// The spin at the start.
  State<Vec> start() const { return {Vec::Zero(), w}; }

  /// Energy of a spin [J]; conserved.
  Real energy(const Vec& now) const { return now.dot(inertia.cwiseProduct(now)) / 2; }

  /// The angular velocity in the body's axes at any time, also before the start [rad/s].
  /// @param t  time since the start [s]
  Vec spin(Real t) const { return Solution(*this).spin(t); }

  /// How the body is turned at a time: from its own axes to what they were at the start.
  ///
  /// The angle about the angular momentum is a quadrature of the exact spin, good to rounding.
  /// @param t  time since the start [s]
  Matrix orientation(Real t) const {
    const Solution exact(*this);
    const auto momentum = [&](Real at) -> Vec {
      return inertia.cwiseProduct(exact.spin(at)).normalized();
    };
    const Vec axis = Vec::Unit(exact.aside);
    const auto frame = [&](const Vec& along, const Vec& to) {
      const Vec side = (to - to.dot(along) * along).normalized();
      return (Matrix() << along, side, along.cross(side)).finished();
    };
    const Real angle = exact.precession(t);
    const Matrix turned = Eigen::AngleAxis<Real>(angle, Vec::UnitX()).toRotationMatrix();
    return frame(momentum(0), axis) * turned * frame(momentum(t), axis).transpose();
  }

  /// The matrix that takes a vector v to w x v.
  static Matrix crossing(const Vec& w) {
    return (Matrix() << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0).finished();
  }

  /// By what angle one orientation is turned against another [rad].
  static Real angle_between(const Matrix& a, const Matrix& b) {
    return 2 * std::asin(std::min(Real(1), (a - b).norm() / std::sqrt(Real(8))));
  }

 private:
  struct Solution {
    Vec inertia, size;        // of the three sines and cosines
    int out, middle, around;  // axes: L goes round the last, and farthest from it along the first
    int aside;                // the axis that L keeps away from
    Real momentum;            // |L|
    Real rate, phase;         // of the argument of the elliptic functions
    Real k, other_k;          // modulus and complementary modulus

    explicit Solution(const EulerTop& top) : inertia(top.inertia) {
      const Vec& spun = top.w;
      int low = 0, high = 2;
      middle = 1;
      const auto sort = [&](int& a, int& b) {
        if (inertia[b] < inertia[a]) std::swap(a, b);
      };
      sort(low, middle), sort(middle, high), sort(low, middle);
      momentum = inertia.cwiseProduct(spun).norm();
      // |L|^2 less 2 E times a moment, from differences that cancel as little as they can.
      const auto beyond = [&](int axis) {
        Real sum = 0;
        for (int i = 0; i < 3; ++i)
          sum += inertia[i] * spun[i] * spun[i] * (inertia[i] - inertia[axis]);
        return sum;
      };
      const bool about_high = beyond(middle) > 0;
      out = about_high ? low : high;
      around = about_high ? high : low;
      const Real Io = inertia[out], Im = inertia[middle], Ia = inertia[around];
      size[out] = std::sqrt(-beyond(around) / (Io * (Ia - Io)));
      size[middle] = std::sqrt(-beyond(around) / (Im * (Ia - Im)));
      size[around] = std::copysign(std::sqrt(beyond(out) / (Ia * (Ia - Io))), spun[around]);
      aside = Io * size[out] < Ia * std::abs(size[around]) ? out : around;
      k = std::sqrt((Im - Io) * -beyond(around) / ((Ia - Im) * beyond(out)));
      other_k = std::sqrt((Ia - Io) * beyond(middle) / ((Ia - Im) * beyond(out)));
      const bool cyclic = (middle - out + 3) % 3 == 1;
      const bool forwards = cyclic == (Ia > Im);
      rate = std::sqrt((Ia - Im) * beyond(out) / inertia.prod());
      if (forwards != (size[around] > 0)) rate = -rate;
      const Real sn = spun[middle] / size[middle], cn = spun[out] / size[out];
      const Real dn = spun[around] / size[around];
      const Real first = sn * carlson(cn * cn, dn * dn);
      const Real half_period = 2 * carlson(0, other_k * other_k);
      phase = cn < 0 ? half_period - first : first;
    }

    Vec spin(Real t) const {
      const Real angle = amplitude(phase + rate * t);
      const Real sn = std::sin(angle), cn = std::cos(angle);
      Vec spun;
      spun[out] = size[out] * cn;
      spun[middle] = size[middle] * sn;
      spun[around] = size[around] * std::hypot(cn, other_k * sn);
      return spun;
    }

    // How far the axis that L keeps away from goes round L, by Gauss's formula of five points.
    Real precession(Real t) const {
      const auto speed = [&](Real at) {
        Vec spun = spin(at);
        spun[aside] = 0;
        const Vec L = inertia.cwiseProduct(spun);
        return momentum * L.dot(spun) / L.squaredNorm();
      };
      const int pieces = 1 + int(8 * size.norm() * std::abs(t));  // of an eighth of a radian
      const Real root = 2 * std::sqrt(Real(10) / 7);
      const Real near = std::sqrt(5 - root) / 3, far = std::sqrt(5 + root) / 3;
      const Real thirteen = 13 * std::sqrt(Real(70));
      const Real half = t / pieces / 2;
      Real sum = 0;
      for (int n = 0; n < pieces; ++n) {
        const Real at = (2 * n + 1) * half;
        sum += Real(128) / 225 * speed(at) +
               (322 + thirteen) / 900 * (speed(at - near * half) + speed(at + near * half)) +
               (322 - thirteen) / 900 * (speed(at - far * half) + speed(at + far * half));
      }
      return half * sum;
    }

    // Jacobi's amplitude: up the arithmetic-geometric means until they meet, and down again by
    // Landen's transformation.
    Real amplitude(Real u) const {
      std::array<Real, 16> ratio{};
      Real arithmetic = 1, geometric = other_k, gap = k;
      std::size_t n = 0;
      while (n + 1 < ratio.size() && gap > 1e-20L * arithmetic) {
        gap = (arithmetic - geometric) / 2;
        const Real mean = (arithmetic + geometric) / 2;
        geometric = std::sqrt(arithmetic * geometric);
        arithmetic = mean;
        ratio[++n] = gap / mean;
      }
      Real angle = std::ldexp(arithmetic * u, int(n));
      for (; n > 0; --n) angle = (angle + std::asin(ratio[n] * std::sin(angle))) / 2;
      return angle;
    }

    // Carlson's integral R_F(x, y, 1), by doubling until the three are one.
    static Real carlson(Real x, Real y) {
      Real z = 1;
      for (int n = 0; n < 40; ++n) {
        const Real l = std::sqrt(x * y) + std::sqrt(y * z) + std::sqrt(z * x);
        x = (x + l) / 4, y = (y + l) / 4, z = (z + l) / 4;
      }
      return 1 / std::sqrt((x + y + z) / 3);
    }
  };
};

}  // namespace scenes
