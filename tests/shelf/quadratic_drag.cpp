// SPDX-License-Identifier: MIT-0
#include "shelf/quadratic_drag.h"

#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>

#include "three.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

template <class Real>
constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

// So many steps of the midpoint rule that two numbers of steps tell what an endless number would.
struct Flown {
  Long x, v;
};

template <class Real>
Long through_air(const Three<Real>& a, const Three<Real>& wind, Real k, const Long& v) {
  const Long through = v + -1.0L * exactly(wind);
  return exactly(a) + (-static_cast<long double>(k) * norm(through)) * through;
}

template <class Real>
Flown flown(Flown now, const Three<Real>& a, const Three<Real>& wind, Real k, long double seconds,
            int steps) {
  const long double h = seconds / steps;
  for (int n = 0; n < steps; ++n) {
    const Long middle = now.v + (h / 2) * through_air(a, wind, k, now.v);
    now.x = now.x + h * middle;
    now.v = now.v + h * through_air(a, wind, k, middle);
  }
  return now;
}

template <class Real>
Flown finely(const Flown& start, const Three<Real>& a, const Three<Real>& wind, Real k,
             long double seconds) {
  const Flown coarse = flown(start, a, wind, k, seconds, 20'000);
  const Flown fine = flown(start, a, wind, k, seconds, 40'000);
  return {fine.x + (1 / 3.0L) * (fine.x + -1.0L * coarse.x),
          fine.v + (1 / 3.0L) * (fine.v + -1.0L * coarse.v)};
}

const Three<double> none{0, 0, 0};

}  // namespace

TEMPLATE_TEST_CASE("A line is gone as finely as one likes, up and down", "", float, double) {
  using Real = TestType;
  for (const Real a : {Real(-9.81), Real(0), Real(3)}) {
    for (const Real k : {Real(0), Real(1e-6), Real(0.01), Real(0.8), Real(20)}) {
      for (const Real start : {Real(-30), Real(-0.01), Real(0), Real(0.01), Real(30)}) {
        for (const Real h : {Real(1e-3), Real(1) / Real(60), Real(2)}) {
          const Three<Real> still{0, 0, 0}, pull{a, 0, 0};
          if (k * h > Real(0.1)) continue;  // for which the midpoints would have to be finer
          const Flown true_one = finely<Real>({{0, 0, 0}, {start, 0, 0}}, pull, still, k, h);
          Real x = 0, v = start;
          shelf::quadratic_drag_fall(x, v, a, k, h);
          const Real fast = std::abs(start) + h * std::abs(a);
          CHECK_THAT(double(x), WithinAbs(double(true_one.x.x), 40 * epsilon<Real> * h * fast));
          CHECK_THAT(double(v), WithinAbs(double(true_one.v.x), 40 * epsilon<Real> * fast));
        }
      }
    }
  }
}

TEST_CASE("Many short steps along a line end where one long one does") {
  for (const double start : {-60.0, -2.0, 0.0, 5.0, 60.0}) {
    for (const double k : {0.0, 1e-9, 0.004, 3.0}) {
      double x = 0, v = start, far = 0, fast = start;
      for (int n = 0; n < 300; ++n) shelf::quadratic_drag_fall(x, v, 9.81, k, 1 / 60.0);
      shelf::quadratic_drag_fall(far, fast, 9.81, k, 5.0);
      CHECK_THAT(x, WithinAbs(far, 1e-11 * (1 + std::abs(far))));
      CHECK_THAT(v, WithinAbs(fast, 1e-12 * (1 + std::abs(start))));
    }
  }
}

TEST_CASE("A fall of an hour goes on at the last speed") {
  double x = 0, v = 0;
  shelf::quadratic_drag_fall(x, v, -9.81, 9.81 / 25, 3600.0);
  CHECK_THAT(v, WithinRel(-5.0, 1e-15));
  CHECK_THAT(x, WithinRel(-5 * 3600 + 25 / 9.81 * std::log(2.0), 1e-14));
}

TEST_CASE("In any direction half the step is a quarter of the error") {
  const Three<double> gravity{0, -9.81, 0}, wind{-5, 1, 8};
  const double k = 0.05;
  const Flown there = finely<double>({{0, 2, 0}, {40, 10, -3}}, gravity, wind, k, 1);
  const auto off = [&](int steps) {
    Three<double> x{0, 2, 0}, v{40, 10, -3};
    for (int n = 0; n < steps; ++n)
      shelf::quadratic_drag(x, v, gravity, wind, k, 1.0 / steps, norm);
    return double(apart(exactly(x), there.x) + apart(exactly(v), there.v));
  };
  CHECK_THAT(off(200) / off(400), WithinAbs(4, 0.05));
  CHECK(off(400) < 1e-3);
}

TEMPLATE_TEST_CASE("What nothing pushes is braked exactly, in any direction and any wind", "",
                   float, double) {
  using Real = TestType;
  for (const Real k : {Real(0), Real(1e-5), Real(0.3), Real(40)}) {
    const Three<Real> wind{3, -4, 12}, still{0, 0, 0};
    Three<Real> x{0, 0, 0}, v{Real(3 + 6), -4 + 2, 12 - 3};  // 7 m/s through the air
    const Real h = Real(0.5);
    shelf::quadratic_drag(x, v, still, wind, k, h, norm);
    Real way = 0, speed = 7;
    shelf::quadratic_drag_fall(way, speed, Real(0), k, h);
    const Real most = Real(60) * epsilon<Real>;
    CHECK_THAT(v.x, WithinAbs(3 + speed / Real(7) * Real(6), most));
    CHECK_THAT(v.z, WithinAbs(12 - speed / Real(7) * Real(3), most));
    CHECK_THAT(x.x, WithinAbs(h * Real(3) + way / Real(7) * Real(6), most));
    CHECK_THAT(x.y, WithinAbs(h * Real(-4) + way / Real(7) * Real(2), most));
  }
}

TEST_CASE("Without air it is thrown as any stone") {
  Three<double> x{1, 2, 3}, v{4, 5, 6};
  shelf::quadratic_drag(x, v, {0, -8, 0}, none, 0.0, 0.5, norm);
  CHECK(x == Three<double>{3, 3.5, 6});
  CHECK(v == Three<double>{4, 1, 6});
}

TEMPLATE_TEST_CASE("No speed and no air is too much", "", float, double) {
  using Real = TestType;
  for (const Real k : {Real(1e-30), Real(1), Real(1e30)}) {
    for (const Real fast : {Real(0), Real(1e-30), Real(1e15)}) {
      Three<Real> x{0, 0, 0}, v{fast, -fast, fast};
      Real way = 0, rises = -fast;
      for (int n = 0; n < 5; ++n) {
        shelf::quadratic_drag(x, v, {0, Real(-9.81), 0}, {1, 0, 0}, k, Real(0.1), norm);
        shelf::quadratic_drag_fall(way, rises, Real(9.81), k, Real(0.1));
      }
      CHECK(std::isfinite(x.x + x.y + x.z + v.x + v.y + v.z));
      CHECK(std::isfinite(way + rises));
      CHECK(norm(v) <= Real(1.75) * fast + Real(10));
    }
  }
}
