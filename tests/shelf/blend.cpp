// SPDX-License-Identifier: MIT-0
#include "shelf/blend.h"

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "three.h"

using Catch::Matchers::WithinAbs;

namespace {

// Of four numbers, with no more than a quaternion of somebody's may have.
template <class Real>
struct Four {
  Real w, x, y, z;

  friend constexpr Four operator+(Four p, Four q) {
    return {p.w + q.w, p.x + q.x, p.y + q.y, p.z + q.z};
  }
  friend constexpr Four operator*(Real s, Four p) { return {s * p.w, s * p.x, s * p.y, s * p.z}; }
};

constexpr auto product = [](const auto& p, const auto& q) {
  return p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z;
};

template <class Real>
Four<Real> about_z(Real angle) {
  return {std::cos(angle / 2), 0, 0, std::sin(angle / 2)};
}

template <class Real>
constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

}  // namespace

TEMPLATE_TEST_CASE("A straight blend goes evenly from the one to the other", "", float, double) {
  using Real = TestType;
  const Three<Real> before{1, -2, 3}, now{9, 6, -5};
  for (int i = 0; i <= 8; ++i) {
    const Three<Real> there = shelf::blend(before, now, Real(i) / 8);
    CHECK(there == Three<Real>{Real(1 + i), Real(-2 + i), Real(3 - i)});
  }
}

TEST_CASE("A curved blend is a path of the third degree, and has its velocities") {
  // x(t) = 2 - t + 3 t^2 - 4 t^3, from t = 0.5 to 1.3.
  const auto x = [](double t) { return 2 - t + 3 * t * t - 4 * t * t * t; };
  const auto v = [](double t) { return -1 + 6 * t - 12 * t * t; };
  const double start = 0.5, h = 0.8;
  for (int i = 0; i <= 64; ++i) {
    const double share = i / 64.0;
    const double drawn =
        shelf::blend_curved(x(start), v(start), x(start + h), v(start + h), h, share);
    CHECK_THAT(drawn, WithinAbs(x(start + share * h), 1e-14));
  }
}

TEST_CASE("Both ends are the places themselves, to the last bit") {
  const double near_it = 0.1, away = 1e9 / 3;
  for (const auto& [before, now] : {std::pair(near_it, away), std::pair(away, near_it)}) {
    for (const double share : {0.0, 1.0}) {
      const double end = share == 0 ? before : now;
      CHECK(shelf::blend(before, now, share) == end);
      CHECK(shelf::blend_curved(before, 1e7, now, -3.0, 0.1, share) == end);
    }
  }
}

TEMPLATE_TEST_CASE("What turns is turned the shorter way, and stays of length one", "", float,
                   double) {
  using Real = TestType;
  for (const Real angle : {Real(0), Real(1e-3), Real(0.5), Real(2.5)}) {
    for (const Real side : {Real(1), Real(-1)}) {
      const Four<Real> from = about_z(Real(0.3)), to = side * about_z(Real(0.3) + angle);
      for (int i = 0; i <= 8; ++i) {
        const Real share = Real(i) / 8;
        const Four<Real> q = shelf::blend_turned(from, to, share, product);
        CHECK_THAT(product(q, q), WithinAbs(Real(1), 4 * epsilon<Real>));
        const Real turned = 2 * std::atan2(q.z, q.w) - Real(0.3);
        CHECK_THAT(turned, WithinAbs(share * angle,
                                     Real(0.0046) * angle * angle * angle + 8 * epsilon<Real>));
        if (i == 4) CHECK_THAT(turned, WithinAbs(angle / 2, 8 * epsilon<Real>));
      }
    }
  }
}

TEST_CASE("The compiler blends, too") {
  constexpr double straight = shelf::blend(1.0, 3.0, 0.25);
  constexpr double curved = shelf::blend_curved(0.0, 8.0, 1.0, 8.0, 0.5, 0.25);
  CHECK(straight == 1.5);
  CHECK(curved == 0.15625 + 0.5 * 0.25 * 0.75 * (0.75 * 8 - 0.25 * 8));
}
