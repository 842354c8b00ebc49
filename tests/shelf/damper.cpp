// SPDX-License-Identifier: MIT-0
#include "shelf/damper.h"

#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "three.h"

using Catch::Matchers::WithinRel;

namespace {

// Two bodies of 1 g to 1 t, at some metres a second, with a damper of h c between 1e-6 and 1e6 kg.
template <class Real>
struct Bodies {
  Three<Real> v1, v2;
  Real w1, w2, h, c;

  long double m1() const { return 1 / (long double)w1; }
  long double m2() const { return 1 / (long double)w2; }
  Long momentum() const { return m1() * exactly(v1) + m2() * exactly(v2); }
  Long parting() const { return exactly(v2) + -1.0L * exactly(v1); }
  long double speeds() const { return norm(exactly(v1)) + norm(exactly(v2)); }
  long double energy() const {
    return m1() * dot(exactly(v1), exactly(v1)) + m2() * dot(exactly(v2), exactly(v2));
  }
};

template <class Real, class Check>
void for_each_pair(Check check) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> speed(-9, 9), mass(-3, 3), pull(-6, 6);
  const auto velocity = [&] {
    return Three<Real>{Real(speed(random)), Real(speed(random)), Real(speed(random))};
  };
  for (int n = 0; n < 500; ++n) {
    const Real h = Real(1) / Real(15 << n % 5);
    check(Bodies<Real>{velocity(), velocity(), Real(std::pow(10, mass(random))),
                       Real(std::pow(10, mass(random))), h, Real(std::pow(10, pull(random))) / h});
  }
}

template <class Real>
Bodies<Real> damped(Bodies<Real> b) {
  shelf::damper(b.v1, b.v2, b.h, b.c, b.w1, b.w2);
  return b;
}

template <class Real>
Bodies<Real> damped_along(Bodies<Real> b, const Three<Real>& along) {
  shelf::damper_along(b.v1, b.v2, b.h, b.c, b.w1, b.w2, along, dot);
  return b;
}

// Ten kilograms in a row, which hang from the first damper: how fast the last one sinks.
double sinks(double c, int substeps) {
  double v[11] = {0};
  const double h = 1 / 60.0 / substeps;
  for (int n = 0; n < 20 * 60 * substeps; ++n) {
    for (int i = 1; i <= 10; ++i) v[i] -= h * 9.81;
    for (int i = 1; i <= 10; ++i) {
      shelf::damper(v[i - 1], v[i], h, c, i == 1 ? 0.0 : 1.0, 1.0);
    }
  }
  return -v[10];
}

}  // namespace

TEMPLATE_TEST_CASE("The speed of parting is divided as a step of backward Euler asks", "", float,
                   double) {
  for_each_pair<TestType>([](const auto& b) {
    const auto after = damped(b);
    // With the velocities u at the end: m1 (u1 - v1) = h c (u2 - u1) = -m2 (u2 - v2).
    const long double rounding = 4 * b.speeds() * std::numeric_limits<TestType>::epsilon();
    const long double pull = (long double)b.h * b.c;
    const Long end = (1 / (1 + pull * ((long double)b.w1 + b.w2))) * b.parting();
    CHECK(apart(after.parting(), end) < rounding);
  });
}

TEMPLATE_TEST_CASE("A damper keeps the momentum of two bodies, along a line too", "", float,
                   double) {
  const Three<TestType> along{TestType(0.36), TestType(0.48), TestType(-0.8)};
  for_each_pair<TestType>([&](const auto& b) {
    const long double most = b.m1() * norm(exactly(b.v1)) + b.m2() * norm(exactly(b.v2));
    const long double rounding = 2 * most * std::numeric_limits<TestType>::epsilon();
    CHECK(apart(damped(b).momentum(), b.momentum()) < rounding);
    CHECK(apart(damped_along(b, along).momentum(), b.momentum()) < rounding);
  });
}

TEMPLATE_TEST_CASE("A damper takes energy, gives none, and turns nothing round", "", float,
                   double) {
  for_each_pair<TestType>([](auto b) {
    for (const TestType pull : {TestType(0), TestType(1e-6), TestType(1), TestType(1e30)}) {
      b.c = pull / b.h;
      const auto after = damped(b);
      const long double rounding = 8 * std::numeric_limits<TestType>::epsilon();
      CHECK(after.energy() <= b.energy() * (1 + rounding));
      CHECK(dot(after.parting(), b.parting()) >= -rounding * b.speeds() * norm(b.parting()));
      CHECK(norm(after.parting()) <= norm(b.parting()) + rounding * b.speeds());
    }
  });
}

TEMPLATE_TEST_CASE("A damper is gentle where it is weak: its first order is h c", "", float,
                   double) {
  for (const double rate : {1e-6, 1e-5, 1e-4, 1e-3}) {
    TestType anchor = 0, v = 1;
    shelf::damper(anchor, v, TestType(1) / 64, TestType(rate * 64), TestType(0), TestType(1));
    const double lost = double(rate / (1 + (long double)rate));
    CHECK(std::abs(double(TestType(1) - v) - lost) <=
          0.51 * double(std::numeric_limits<TestType>::epsilon()));
    CHECK(anchor == 0);
  }
}

TEMPLATE_TEST_CASE("An immovable body keeps its velocity, and two of them both", "", float,
                   double) {
  for_each_pair<TestType>([](auto b) {
    b.w1 = 0;
    CHECK(damped(b).v1 == b.v1);
    b.w2 = 0;
    CHECK(damped(b).v1 == b.v1);
    CHECK(damped(b).v2 == b.v2);
    CHECK(damped_along(b, Three<TestType>{0, 0, 1}).v2 == b.v2);
  });
}

TEMPLATE_TEST_CASE("Along a line, only what goes along it is damped", "", float, double) {
  const Three<TestType> axis{0, 1, 0};
  const TestType third = TestType(1) / 3, two_thirds = TestType(2) / 3;
  for_each_pair<TestType>([&](const auto& b) {
    const auto after = damped_along(b, axis);
    CHECK(after.v1.x == b.v1.x);
    CHECK(after.v2.z == b.v2.z);
    CHECK(after.v1.y == damped(b).v1.y);
    CHECK(after.v2.y == damped(b).v2.y);
    const Three<TestType> slanted{third, two_thirds, -two_thirds};
    const auto change = damped_along(b, slanted).parting() + -1.0L * b.parting();
    const Long along = exactly(slanted);
    const Long across = change + (-dot(change, along) / dot(along, along)) * along;
    CHECK(norm(across) < 4 * b.speeds() * std::numeric_limits<TestType>::epsilon());
  });
}

TEST_CASE("No frame makes a damper wrong: at uneven steps the rates multiply") {
  double v1 = 3, v2 = -2;
  long double left = 5;
  for (const double h : {0.016, 0.017, 0.033, 0.008, 0.25, 1e-6}) {
    shelf::damper(v1, v2, h, 6.0, 0.5, 1.0);
    left /= 1 + (long double)h * 6 * 1.5L;
  }
  CHECK_THAT(v1 - v2, WithinRel(double(left), 1e-14));
  CHECK_THAT(2 * v1 + v2, WithinRel(4.0, 1e-14));
}

TEST_CASE("A damper is worked out by the compiler") {
  constexpr double trailer = [] {
    double v1 = 4, v2 = 0;
    shelf::damper(v1, v2, 0.5, 2.0, 0.5, 0.5);
    return v2;
  }();
  CHECK(trailer == 1);
}

TEST_CASE("A row that carries a load gives way, however strong its dampers") {
  for (const double c : {1e4, 1e6}) {
    CHECK_THAT(sinks(c, 1), WithinRel(7.4, 0.01));
    CHECK_THAT(sinks(c, 8), WithinRel(0.95, 0.04));
  }
}
