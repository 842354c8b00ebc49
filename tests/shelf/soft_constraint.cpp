// SPDX-License-Identifier: MIT-0
#include "shelf/soft_constraint.h"

#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include "three.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double h = 1 / 60.0;
constexpr double angles[] = {1e-6, 1e-4, 1e-2, 0.1, 0.5236, 1, 3, 100, 1000};
constexpr double ratios[] = {0, 1e-6, 0.2, 0.7, 0.999, 1, 1.001, 2, 10};

// A thing on a joint to an anchor at 0, by the header.
struct Jointed {
  double x, v, impulse = 0, anchor = 0;

  void step(const shelf::Softness<double>& soft, double w = 1) {
    shelf::soft_warm_start(anchor, v, impulse, 1.0, 0.0, w);
    shelf::soft_constraint(anchor, v, impulse, 1.0, x, 0.0, w, soft,
                           [](double p, double q) { return p * q; });
    x = x + h * v;
  }
};

// The multiplier of one step of backward Euler, of the slower root of
// r^2 + 2 zeta omega r + omega^2: 1 / (1 - h r).
std::complex<long double> multiplier(long double angle, long double zeta) {
  using Complex = std::complex<long double>;
  const Complex root = std::sqrt(Complex(zeta * zeta - 1));
  const Complex rate = zeta > 1 ? Complex(-1) / (zeta + root) : -zeta + root;
  return Complex(1) / (Complex(1) - angle * rate);
}

}  // namespace

TEMPLATE_TEST_CASE("A soft constraint makes the step of backward Euler of its spring", "", float,
                   double) {
  const TestType step = TestType(1) / 64, rounding = std::numeric_limits<TestType>::epsilon();
  for (const double angle : angles) {
    for (const double zeta : ratios) {
      for (const double v0 : {-1.0, 0.0, 1.0}) {
        CAPTURE(angle, zeta, v0);
        const TestType omega = TestType(angle * 64);
        const auto soft = shelf::softness(step, omega, TestType(zeta));
        TestType anchor = 0, v = TestType(v0), impulse = 0;
        const TestType x = TestType(0.01);
        shelf::soft_constraint(anchor, v, impulse, TestType(1), x, TestType(0), TestType(0.25),
                               soft, [](TestType p, TestType q) { return p * q; });
        // v1 = v + h (-omega^2 (x + h v1) - 2 zeta omega v1).
        const long double exact = (v0 - (long double)step * omega * omega * x) /
                                  (1 + 2 * (long double)TestType(zeta) * step * omega +
                                   (long double)step * step * omega * omega);
        CHECK_THAT(double(v), WithinAbs(double(exact), 8 * rounding * (std::abs(v0) + x / step)));
        CHECK(anchor == 0);
        CHECK_THAT(double(impulse),
                   WithinAbs(4 * (double(exact) - v0), 64 * rounding * (std::abs(v0) + x / step)));
      }
    }
  }
}

TEMPLATE_TEST_CASE("The three numbers keep their digits, however soft or stiff", "", float,
                   double) {
  const TestType step = TestType(1) / 64;
  const double rounding = 4 * double(std::numeric_limits<TestType>::epsilon());
  for (const double angle : angles) {
    for (const double zeta : ratios) {
      CAPTURE(angle, zeta);
      const auto soft = shelf::softness(step, TestType(angle * 64), TestType(zeta));
      const long double a = TestType(angle * 64) * (long double)step, z = TestType(zeta);
      CHECK_THAT(double(soft.mass_scale),
                 WithinRel(double((2 * z * a + a * a) / (1 + 2 * z * a + a * a)), rounding));
      CHECK_THAT(double(soft.impulse_scale),
                 WithinRel(double(1 / (1 + 2 * z * a + a * a)), rounding));
      CHECK_THAT(double(soft.bias_rate), WithinRel(double(a / (2 * z + a) / step), rounding));
    }
  }
}

TEST_CASE("A soft constraint of no frequency does nothing, and takes a warm start back") {
  const auto soft = shelf::softness(h, 0.0, 0.0);
  Jointed free{2, 3, 7};
  free.step(soft);
  CHECK(free.v == 3);
  CHECK(free.impulse == 0);
}

TEMPLATE_TEST_CASE("From any warm start, once or three times solved, the velocities are the same",
                   "", float, double) {
  using Vec = Three<TestType>;
  const Vec along{TestType(0.6), 0, TestType(0.8)};
  const TestType w1 = TestType(0.5), w2 = 2, none = 0;
  for (const double angle : {1e-3, 0.1, 1.0, 10.0}) {
    const auto soft = shelf::softness(TestType(1) / 60, TestType(60 * angle), TestType(0.3));
    const auto solved = [&](TestType warm, int times) {
      Vec v[] = {{1, 2, 3}, {-1, 0, 5}};
      TestType impulse = warm;
      shelf::soft_warm_start(v[0], v[1], warm, along, w1, w2);
      for (int n = 0; n < times; ++n) {
        shelf::soft_constraint(v[0], v[1], impulse, along, TestType(0.05), w1, w2, soft, dot);
      }
      return std::pair(v[0], v[1]);
    };
    const auto cold = solved(none, 1);
    CHECK_FALSE(cold.first == Vec{1, 2, 3});
    for (const double warm : {-3.0, 0.0, 0.7, 50.0}) {
      for (const int times : {1, 2, 3}) {
        CAPTURE(angle, warm, times);
        const auto end = solved(TestType(warm), times);
        const double rounding =
            8 * double(std::numeric_limits<TestType>::epsilon()) * (6 + std::abs(warm) * 2.5);
        CHECK(apart(exactly(end.first), exactly(cold.first)) < rounding);
        CHECK(apart(exactly(end.second), exactly(cold.second)) < rounding);
      }
    }
  }
}

TEMPLATE_TEST_CASE("A soft constraint keeps the momentum, and an immovable body its velocity", "",
                   float, double) {
  using Vec = Three<TestType>;
  const Vec along{TestType(0.6), 0, TestType(0.8)}, start1{1, 2, 3}, start2{-1, 0, 5};
  const auto soft = shelf::softness(TestType(1) / 60, TestType(30), TestType(0.3));
  for (const double ratio : {1e-6, 0.1, 1.0, 1e3}) {
    const TestType w1 = TestType(ratio), w2 = 1;
    Vec v1 = start1, v2 = start2;
    TestType impulse = 2;
    shelf::soft_warm_start(v1, v2, impulse, along, w1, w2);
    shelf::soft_constraint(v1, v2, impulse, along, TestType(0.1), w1, w2, soft, dot);
    const auto momentum = [&](const Vec& p, const Vec& q) {
      return (1 / (long double)w1) * exactly(p) + exactly(q);
    };
    const long double rounding = 16 * std::numeric_limits<TestType>::epsilon();
    CHECK(apart(momentum(v1, v2), momentum(start1, start2)) <
          rounding * norm(momentum(start1, start2)));
  }
  Vec v1 = start1, v2 = start2;
  TestType impulse = 0;
  shelf::soft_constraint(v1, v2, impulse, along, TestType(0.1), TestType(0), TestType(1), soft,
                         dot);
  CHECK(v1 == start1);
  CHECK_FALSE(v2 == start2);
  v2 = start2, impulse = 0;
  shelf::soft_constraint(v1, v2, impulse, along, TestType(0.1), TestType(0), TestType(0), soft,
                         dot);
  CHECK(v2 == start2);
  CHECK(impulse == 0);
}

TEST_CASE("soft_motion tells the swing and the decay of one step's multiplier") {
  for (const double angle : angles) {
    for (const double zeta : ratios) {
      CAPTURE(angle, zeta);
      const auto real = shelf::soft_motion(h, angle / h, zeta);
      const auto once = multiplier(angle, zeta);
      if (zeta < 1) {
        CHECK_THAT(real.swing * h, WithinRel(double(std::abs(std::arg(once))), 1e-9));
        const double decay = -double(std::log(std::norm(once))) / 2;
        CHECK_THAT(real.zeta * real.omega * h, WithinRel(decay, 1e-6));
        CHECK_THAT(std::hypot(real.swing, real.zeta * real.omega), WithinRel(real.omega, 1e-12));
      } else {
        CHECK(real.swing == 0);
        CHECK(real.zeta >= 1 - 1e-12);
        // The slower of its two rates, by a root that does not subtract.
        const double root = std::sqrt(std::max(0.0, real.zeta * real.zeta - 1));
        const double slow = real.omega / (real.zeta + root);
        CHECK_THAT(std::exp(-slow * h), WithinRel(double(once.real()), 1e-6));
      }
    }
  }
}

TEST_CASE("The spring of soft_motion, left alone, is where the constraint is after each step") {
  for (const double angle : {1e-3, 0.1, 0.5236, 2.0, 30.0}) {
    for (const double zeta : {0.0, 0.1, 0.7, 1.5, 10.0}) {
      CAPTURE(angle, zeta);
      const auto soft = shelf::softness(h, angle / h, zeta);
      const auto real = shelf::soft_motion(h, angle / h, zeta);
      Jointed jointed{1, -2};
      double before = jointed.x;
      jointed.step(soft);
      double now = jointed.x;
      // All solutions of the exact spring obey x_{n+1} = 2 e^{-d} c x_n - e^{-2d} x_{n-1}.
      const double d = real.zeta * real.omega * h;
      const double apart = real.omega * h * std::sqrt(std::abs(1 - real.zeta * real.zeta));
      const double c = real.swing > 0 ? std::cos(real.swing * h) : std::cosh(apart);
      for (int n = 0; n < 50; ++n) {
        const double next = 2 * std::exp(-d) * c * now - std::exp(-2 * d) * before;
        before = now, now = next;
        jointed.step(soft);
        CHECK_THAT(jointed.x, WithinAbs(now, 1e-11));
      }
    }
  }
}

TEST_CASE("Asked for 5 Hz without damping, it swings at 4.6 Hz at 60 steps a second, 3.9 at 30") {
  using std::numbers::pi;
  struct Known {
    int rate;
    double hertz, zeta;
  };
  for (const auto& [rate, hertz, zeta] :
       {Known{30, 3.860, 0.4163}, Known{60, 4.606, 0.2436}, Known{240, 4.972, 0.0651}}) {
    const auto real = shelf::soft_motion(1.0 / rate, 10 * pi, 0.0);
    CHECK_THAT(real.swing / (2 * pi), WithinAbs(hertz, 5e-4));
    CHECK_THAT(real.zeta, WithinAbs(zeta, 5e-4));
    CHECK_THAT(real.swing, WithinRel(std::atan(10 * pi / rate) * rate, 1e-14));
  }
}

TEST_CASE("However stiff, a soft constraint never grows") {
  for (const double angle : {0.1, 1.0, 1e2, 1e4, 1e6}) {
    for (const double zeta : {0.0, 0.5, 5.0}) {
      const auto soft = shelf::softness(h, angle / h, zeta);
      Jointed jointed{1, 0};
      for (int n = 0; n < 100; ++n) {
        jointed.step(soft);
        CHECK(std::abs(jointed.x) <= 1);
      }
    }
  }
}

TEMPLATE_TEST_CASE("The lowest frequency there is gives a constraint that does nothing", "", float,
                   double) {
  const TestType least = std::numeric_limits<TestType>::denorm_min();
  const auto soft = shelf::softness(TestType(1) / 64, least, TestType(0));
  CHECK(soft.bias_rate == 0);
  CHECK(soft.mass_scale == 0);
  CHECK(soft.impulse_scale == 1);
}
