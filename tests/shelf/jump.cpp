// SPDX-License-Identifier: MIT-0
#include "shelf/jump.h"

#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>
#include <random>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

// A stone that is thrown, in so many short steps that they are a grid of its own path: each pull is
// that of where it is.
struct Stone {
  static constexpr int parts = 20'000;
  long double x = 0, v = 0;

  void fly(long double rising, long double falling, long double seconds) {
    const long double h = seconds / parts;
    for (int n = 0; n < parts; ++n) {
      const long double middle = v - h / 2 * (v > 0 ? rising : falling);
      const long double pull = middle > 0 ? rising : falling;
      x += h * v - h * h / 2 * pull;
      v -= h * pull;
    }
  }
};

template <class Real>
constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

}  // namespace

TEMPLATE_TEST_CASE("A jump is at its top when it should be, and as high", "", float, double) {
  using Real = TestType;
  for (const double height : {0.01, 1.3, 40.0}) {
    for (const double time : {0.05, 0.44, 3.0}) {
      const auto jump = shelf::jump_to(Real(height), Real(time));
      for (const int steps : {1, 7, 60}) {
        Real x = 0, v = jump.speed;
        for (int n = 0; n < steps; ++n)
          shelf::jump_step(x, v, jump.gravity, jump.gravity, Real(time) / Real(steps));
        CHECK_THAT(x, WithinRel(Real(height), Real(4 * steps + 8) * epsilon<Real>));
        CHECK_THAT(v, WithinAbs(Real(0), Real(2 * steps + 4) * epsilon<Real> * jump.speed));
      }
    }
  }
}

TEST_CASE("In any frames it rises under one pull and falls under the other") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0.02, 1);
  // The grid takes one of the pulls where the other is right for less than a part of a frame.
  constexpr double most_pull = 90, longest = 0.2;
  constexpr double v_off = most_pull * longest / Stone::parts, x_off = v_off * 6 * longest;
  for (int n = 0; n < 40; ++n) {
    const double rising = most_pull * share(random), falling = most_pull * share(random);
    Stone stone{0, 12.0L * share(random)};
    double x = 0, v = double(stone.v);
    for (int frame = 0; frame < 6; ++frame) {
      const double h = longest * share(random);
      shelf::jump_step(x, v, rising, falling, h);
      stone.fly(rising, falling, h);
      CHECK_THAT(x, WithinAbs(double(stone.x), x_off));
      CHECK_THAT(v, WithinAbs(double(stone.v), v_off));
    }
  }
}

TEMPLATE_TEST_CASE("Let go at once it rises as high as it was asked to", "", float, double) {
  using Real = TestType;
  for (const double height : {0.001, 1.0, 30.0}) {
    const Real speed = Real(18.2), pull = shelf::jump_gravity(speed, Real(height));
    Real x = 0, v = speed, top = 0;
    while (v > Real(0)) {
      shelf::jump_step(x, v, pull, Real(0), speed / pull / Real(7.5));
      top = std::max(top, x);
    }
    CHECK_THAT(top, WithinRel(Real(height), Real(40) * epsilon<Real>));
    CHECK(v == Real(0));
  }
}

TEST_CASE("What does not rise falls, whatever would pull it down while it rises") {
  for (const double speed : {0.0, -1.0, -50.0}) {
    double x = 3, v = speed;
    shelf::jump_step(x, v, 1000.0, 8.0, 0.5);
    CHECK(x == 3 + 0.5 * speed - 1);
    CHECK(v == speed - 4);
  }
}

TEST_CASE("Without a pull it rises for ever, and a step of nothing changes nothing") {
  double x = 1, v = 5;
  shelf::jump_step(x, v, 0.0, 8.0, 2.0);
  CHECK(x == 11);
  CHECK(v == 5);
  shelf::jump_step(x, v, 20.0, 8.0, 0.0);
  CHECK(x == 11);
  CHECK(v == 5);
}

TEST_CASE("The step and what it needs are known to the compiler") {
  constexpr double top = [] {
    const auto jump = shelf::jump_to(4.0, 0.5);
    double x = 0, v = jump.speed;
    for (int n = 0; n < 4; ++n) shelf::jump_step(x, v, jump.gravity, jump.gravity, 0.125);
    return x;
  }();
  CHECK(top == 4);
}
