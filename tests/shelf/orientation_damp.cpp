// SPDX-License-Identifier: MIT-0
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>

#include "shelf/orientation.h"

using Catch::Matchers::WithinAbs;
using shelf::Quaternion;
using shelf::Vec3;

namespace {

template <class Real>
Quaternion<Real> turned(const Vec3<Real>& by) {
  Quaternion<Real> q;
  shelf::turn_exact(q, by, Real(1));
  return q;
}

template <class Real>
Real length(const Vec3<Real>& v) {
  return std::sqrt(dot(v, v));
}

}  // namespace

TEMPLATE_TEST_CASE("The turn between two orientations is the shorter one, small or large", "",
                   float, double) {
  using Real = TestType;
  constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
  const Quaternion<Real> from = turned<Real>({Real(0.3), -1, 2});
  for (const Real angle : {Real(0), Real(1e-12), Real(1e-3), Real(1), Real(3.1)}) {
    const Vec3<Real> by{Real(0.6) * angle, 0, Real(-0.8) * angle};
    Quaternion<Real> q = from;
    shelf::turn_exact(q, by, Real(1));
    for (const Real sign : {Real(1), Real(-1)}) {
      const Quaternion<Real> same{sign * q.w, sign * q.x, sign * q.y, sign * q.z};
      const Vec3<Real> found = shelf::turn_between(same, from);
      CHECK_THAT(length(found + Real(-1) * by), WithinAbs(Real(0), 16 * epsilon));
    }
  }
}

// About one axis the spring has a formula: (way + (speed + omega way) t) exp(-omega t).
TEST_CASE("About one axis a follower is the critically damped spring") {
  const double omega = 3, start = -1.2, speed = 4, target_speed = 0.7;
  const Vec3<double> axis{0, 0.6, 0.8};
  Quaternion<double> q = turned(start * axis), target;
  Vec3<double> w = speed * axis;
  double t = 0;
  for (const double h : {0.01, 0.2, 1e-4, 0.05, 0.4}) {
    t += h;
    target = turned((target_speed * t) * axis);
    shelf::turn_damp(q, w, target, target_speed * axis, omega, h);
    const double way = (start + (speed - target_speed + omega * start) * t) * std::exp(-omega * t);
    const double rate = (speed - target_speed + omega * start) * std::exp(-omega * t) - omega * way;
    CHECK_THAT(dot(shelf::turn_between(q, target), axis), WithinAbs(way, 1e-14));
    CHECK_THAT(dot(w, axis), WithinAbs(target_speed + rate, 1e-13));
    CHECK_THAT(length(cross(w, axis)), WithinAbs(0, 1e-14));
  }
}

TEST_CASE("A follower of what rests is the same in one step and in many, about any axes") {
  const Quaternion<double> target = turned<double>({1, -0.5, 0.4});
  const auto after = [&](int steps) {
    Quaternion<double> q;
    Vec3<double> w{-2, 1, 3};
    for (int n = 0; n < steps; ++n) shelf::turn_damp(q, w, target, {0, 0, 0}, 5, 0.6 / steps);
    return q;
  };
  CHECK_THAT(length(shelf::turn_between(after(1), after(70))), WithinAbs(0, 1e-13));
}

TEST_CASE("A follower turns the shorter way, and is there at last") {
  for (const double angle : {3.1, -3.1}) {
    const Quaternion<double> target = turned<double>({0, angle, 0});
    const Quaternion<double> other{-target.w, -target.x, -target.y, -target.z};
    Quaternion<double> q;
    Vec3<double> w;
    shelf::turn_damp(q, w, other, {0, 0, 0}, 5, 1 / 60.0);
    CHECK(w.y * angle > 0);
    shelf::turn_damp(q, w, other, {0, 0, 0}, 5, 1000.0);
    CHECK_THAT(length(shelf::turn_between(q, target)), WithinAbs(0, 1e-15));
    CHECK_THAT(length(w), WithinAbs(0, 1e-15));
  }
}
