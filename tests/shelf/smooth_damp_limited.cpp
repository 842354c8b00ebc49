// SPDX-License-Identifier: MIT-0
#include <Eigen/Core>
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "frames/recorded.h"
#include "shelf/smooth_damp.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using Eigen::Vector2d;

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();
const auto product = [](auto p, auto q) { return p * q; };
const auto dot = [](const Vector2d& p, const Vector2d& q) { return p.dot(q); };

Vector2d cut(const Vector2d& v, double most) {
  return v.norm() > most ? v * (most / v.norm()) : v;
}

struct Follower {
  Vector2d x{0, 0}, v{0, 0};
};

// What the limits mean, in short steps: towards a target that starts at (8, 3) and moves on.
Follower truth(double omega, double top, double most, const Vector2d& moves, double duration) {
  Follower f;
  constexpr int steps = 20'000;
  const double h = duration / steps;
  for (int n = 0; n < steps; ++n) {
    const auto pulled = [&](const Vector2d& x, const Vector2d& v, double t) {
      const Vector2d way = Vector2d(8, 3) + t * moves - x;
      return cut(2 * omega * (cut(moves + omega / 2 * way, top) - v), most);
    };
    const Vector2d middle = f.v + h / 2 * pulled(f.x, f.v, n * h);
    const Vector2d there = pulled(f.x + h / 2 * f.v, middle, (n + 0.5) * h);
    f.x += h * middle;
    f.v += h * there;
  }
  return f;
}

}  // namespace

TEST_CASE("Without limits the limited spring is smooth_damp to the bit") {
  Follower f{{1, -2}, {30, 4}}, free = f;
  frames::Playback frame;
  for (int n = 0; n < 200; ++n) {
    const double h = frame.next();
    const Vector2d target(0.1 * n, -0.2 * n), moves(6, -12);
    shelf::smooth_damp_limited(f.x, f.v, target, moves, 4.0, no_limit, no_limit, h, dot);
    shelf::smooth_damp(free.x, free.v, target, moves, 4.0, h);
    REQUIRE(f.x == free.x);
    REQUIRE(f.v == free.v);
  }
}

TEST_CASE("Each limit alone and both together hold in the plane, behind what moves") {
  const Vector2d moves(-1, 2);
  for (const auto& [top, most] : {std::pair(4.0, no_limit), {no_limit, 6.0}, {4.0, 6.0}}) {
    CAPTURE(top, most);
    const auto off = [&](int rate) {
      Follower f;
      for (int n = 1; n <= 2 * rate; ++n) {
        const Vector2d target = Vector2d(8, 3) + double(n) / rate * moves;
        const double before = f.v.norm();
        const Vector2d velocity = f.v;
        shelf::smooth_damp_limited(f.x, f.v, target, moves, 3.0, top, most, 1.0 / rate, dot);
        REQUIRE(f.v.norm() <= std::max(before, top) * (1 + 1e-14));
        REQUIRE((f.v - velocity).norm() <= most / rate * (1 + 1e-13));
      }
      return (f.x - truth(3, top, most, moves, 2).x).norm();
    };
    CHECK(off(60) < 0.01);
    CHECK(off(960) < 1e-4);
  }
}

TEST_CASE("However long the steps and whatever moves, it goes no faster than it may") {
  for (const double h : {0.05, 0.125, 0.25, 0.5}) {
    for (const double speed : {3.0, 10.0, 50.0}) {
      for (int start = -60; start <= 20; ++start) {  // from behind it and past it
        CAPTURE(h, speed, start);
        Follower f;
        for (int n = 1; n < 20; ++n) {
          const Vector2d place = f.x, target(0.5 * start + speed * n * h, 0.3);
          shelf::smooth_damp_limited(f.x, f.v, target, Vector2d(speed, 0), 4.0, 5.0, no_limit, h,
                                     dot);
          REQUIRE(f.v.norm() <= 5 * (1 + 1e-14));
          REQUIRE((f.x - place).norm() <= 5 * h * (1 + 1e-12));
        }
      }
    }
  }
}

TEST_CASE("A target that is faster than the top speed gets away, and is chased at that speed") {
  Follower f;
  for (int n = 1; n <= 600; ++n) {
    shelf::smooth_damp_limited(f.x, f.v, Vector2d(n / 60.0 * 9, 0), Vector2d(9, 0), 4.0, 5.0,
                               no_limit, 1 / 60.0, dot);
  }
  CHECK_THAT(f.v.x(), WithinRel(5.0, 1e-12));
  CHECK_THAT(f.v.y(), WithinAbs(0, 1e-12));
}

TEST_CASE("What is too fast is braked to the top speed, by no more than the top acceleration") {
  double x = 0, v = 50;
  for (int n = 0; n < 60; ++n) {
    const double before = v;
    shelf::smooth_damp_limited(x, v, 1000.0, 0.0, 4.0, 5.0, 20.0, 1 / 60.0, product);
    REQUIRE_THAT(v, WithinAbs(before - 20 / 60.0, 1e-12));
  }
  for (int n = 0; n < 600; ++n) {
    shelf::smooth_damp_limited(x, v, 1000.0, 0.0, 4.0, 5.0, 20.0, 1 / 60.0, product);
  }
  CHECK_THAT(v, WithinRel(5.0, 1e-12));
}

TEST_CASE("With too little acceleration to stop in time it passes its target") {
  double x = 0, v = 0, furthest = 0;
  for (int n = 0; n < 600; ++n) {
    shelf::smooth_damp_limited(x, v, 10.0, 0.0, 4.0, 5.0, 3.0, 1 / 60.0, product);
    furthest = std::max(furthest, x);
  }
  CHECK(furthest > 10.5);
}

TEMPLATE_TEST_CASE("Limits of zero, no spring and no step are what they say", "", float, double) {
  const auto step = [](TestType& x, TestType& v, TestType omega, TestType top, TestType most,
                       TestType h) {
    shelf::smooth_damp_limited(x, v, TestType(9), TestType(6), omega, top, most, h, product);
  };
  TestType x = 1, v = 2;
  step(x, v, 4, 5, 20, 0);
  CHECK((x == 1 && v == 2));
  step(x, v, 4, 5, 0, TestType(0.5));
  CHECK((x == 2 && v == 2));
  step(x, v, 0, 5, 20, TestType(0.5));
  CHECK((x == 3 && v == 2));
  for (int n = 0; n < 100; ++n) step(x, v, 4, 0, TestType(1e9), TestType(0.5));
  CHECK(std::abs(v) < TestType(1e-30));
  const TestType nan = std::numeric_limits<TestType>::quiet_NaN();
  step(x, v, 4, 5, 20, nan);
  CHECK((std::isnan(x) && std::isnan(v)));
}
