// SPDX-License-Identifier: MIT-0
// What bounces off a plane that moves and tilts, or is carried by it.
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>

#include "shelf/bounce.h"
#include "three.h"

using Catch::Matchers::WithinAbs;

namespace {

constexpr double g = 9.81;
constexpr auto times = [](auto p, auto q) { return p * q; };

template <class Real>
using Moving = shelf::MovingPlane<Three<Real>, Real>;
using Vec = Three<double>;

// A lift that swings by 2 m, up and down and to the side, with a ball of 25 cm.
template <class Real>
Moving<Real> lift(double omega, double side, double t) {
  const double x = 2 * std::sin(omega * t), v = 2 * omega * std::cos(omega * t);
  return {{{0, 0, 1}, Real(0.25), Real(0.5), Real(1), Real(0.5)},
          {Real(side * x), 0, Real(x)},
          {Real(side * v), 0, Real(v)}};
}

}  // namespace

TEMPLATE_TEST_CASE("A lift that swings carries its ball, up and down and to the side", "", float,
                   double) {
  const double rounding = std::numeric_limits<TestType>::epsilon();
  for (const int rate : {15, 60, 240}) {
    CAPTURE(rate);
    Three<TestType> x{0, 0, TestType(0.25)}, v = lift<TestType>(2, 0.1, 0).v;
    for (int n = 0; n < 5 * rate; ++n) {
      const auto now = lift<TestType>(2, 0.1, (n + 1.0) / rate);
      const int bounces = shelf::bounce_step(x, v, {0, 0, TestType(-g)}, TestType(1.0 / rate),
                                             lift<TestType>(2, 0.1, double(n) / rate), now, dot);
      REQUIRE(bounces == 0);
      REQUIRE(std::abs(x.z - TestType(0.25) - now.x.z) < 8 * rounding);
      REQUIRE(std::abs(x.x - now.x.x) < n * rounding + 8 * rounding);
      REQUIRE(v == now.v);
    }
  }
}

TEST_CASE("What a lift doesn't touch flies as if there were none, to the bit") {
  Vec x{0, 0, 9}, v{1, 2, 3};
  const double h = 1 / 60.0;
  const Vec there = x + (h * v + (h * h / 2) * Vec{0, 0, -g}), then = v + h * Vec{0, 0, -g};
  CHECK(shelf::bounce_step(x, v, {0, 0, -g}, h, lift<double>(2, 0.1, 0.3),
                           lift<double>(2, 0.1, 0.3 + h), dot) == 0);
  CHECK(x == there);
  CHECK(v == then);
}

TEST_CASE("A lift that falls faster than a stone is left, where that begins") {
  const int rate = 240;
  const double leaves = std::asin(g / 18) / 3;
  const Moving<double> there = lift<double>(3, 0, leaves);
  Vec x{0, 0, 0.25}, v{0, 0, 6};
  for (int n = 1; n <= rate * 8 / 10; ++n) {
    const double t = double(n) / rate, since = std::max(0.0, t - leaves);
    const Moving<double> now = lift<double>(3, 0, t);
    shelf::bounce_step(x, v, {0, 0, -g}, 1.0 / rate, lift<double>(3, 0, t - 1.0 / rate), now, dot);
    const double flown = since > 0 ? there.x.z + (there.v.z - g * since / 2) * since : now.x.z;
    CHECK_THAT(x.z, WithinAbs(flown + 0.25, 1e-4));
  }
}

TEST_CASE("From a floor that rises a ball comes back with its share of how fast they meet") {
  for (const double up : {-2.0, 1.5, 4.0}) {
    for (const double share : {0.3, 0.8}) {
      const auto floor = [&](double t) {
        return shelf::MovingPlane<double, double>{{1, 0, share, 0, 0.1}, up * t, up};
      };
      double x = 2, v = 0;
      int bounces = 0, n = 0;
      for (; bounces == 0; ++n)
        bounces +=
            shelf::bounce_step(x, v, -g, 1 / 64.0, floor(n / 64.0), floor((n + 1) / 64.0), times);
      const double meets = (std::sqrt(up * up + 4 * g) - up) / g, since = n / 64.0 - meets;
      CHECK(bounces == 1);
      CHECK_THAT(v, WithinAbs(up + share * (up + g * meets) - g * since, 1e-12));
      CHECK_THAT(x, WithinAbs(up * meets + (v + g * since / 2) * since, 1e-12));
    }
  }
}

TEST_CASE("A belt takes along what lies on it, with mu g until it is as fast") {
  const auto belt = [](double t) {
    return Moving<double>{{{0, 0, 1}, 0, 0.5, 0.3, 0.5}, {0, 2 * t, 0}, {0, 2, 0}};
  };
  Vec x{0, 0, 0}, v{0, 0, 0};
  for (int n = 0; n < 60; ++n) {
    shelf::bounce_step(x, v, {0, 0, -g}, 1 / 60.0, belt(n / 60.0), belt((n + 1) / 60.0), dot);
    CHECK_THAT(v.y, WithinAbs(std::min(2.0, 0.3 * g * (n + 1) / 60), 1e-12));
  }
  const double catches = 2 / (0.3 * g);
  CHECK_THAT(x.y, WithinAbs(catches + 2 * (1 - catches), 0.3 * g / 8 / 3600));
  CHECK(x.z == 0);
}

TEST_CASE("A floor that tilts keeps what lies on it, and what slides down on it") {
  const double omega = 0.3, mu = 0.2, h = 1 / 60.0;
  const auto up = [=](double t) { return Vec{-std::sin(omega * t), 0, std::cos(omega * t)}; };
  const auto along = [=](double t) { return Vec{std::cos(omega * t), 0, std::sin(omega * t)}; };
  Vec x{0.5, 0, 0}, v = 0.5 * omega * Vec{0, 0, 1};
  for (int n = 0; n < 100; ++n) {
    const double far = dot(x, along(n * h));
    const auto floor = [&](double t) {
      return Moving<double>{{up(t), 0, 0.5, mu, 0.5}, far * along(t), (far * omega) * up(t)};
    };
    CHECK(shelf::bounce_step(x, v, {0, 0, -g}, h, floor(n * h), floor((n + 1) * h), dot) == 0);
    REQUIRE_THAT(dot(x, up((n + 1) * h)), WithinAbs(0, 1e-15));
    const bool holds = std::tan(omega * (n + 2) * h) < mu - 0.01;
    if (holds) CHECK_THAT(dot(x, along((n + 1) * h)), WithinAbs(0.5, 1e-12));
  }
  CHECK(dot(x, along(100 * h)) < 0.4);
}

TEST_CASE("In no time a moving plane does nothing") {
  for (const double h : {0.0, double(NAN)}) {
    Vec x{0, 0, -1}, v{1, 2, -3};
    const Moving<double> plane = lift<double>(2, 0, 0.1);
    CHECK(shelf::bounce_step(x, v, {0, 0, -g}, h, plane, plane, dot) == 0);
    CHECK(x == Vec{0, 0, -1});
    CHECK(v == Vec{1, 2, -3});
  }
}

TEMPLATE_TEST_CASE("Who stands on a lift may jump from it at any moment", "", float, double) {
  const auto product = [](TestType a, TestType b) { return a * b; };
  const auto lift = [](double t) {
    return shelf::MovingPlane<TestType, TestType>{
        {1, TestType(0.9), 0, TestType(0.4), TestType(0.5)},
        TestType(10 + 2 * std::sin(t)),
        TestType(2 * std::cos(t))};
  };
  TestType x = lift(0).x + TestType(0.9), v = lift(0).v;
  const TestType h = 1 / TestType(60), down = TestType(-9.81);
  for (int n = 0; n < 600; ++n) {
    const auto before = lift(n / 60.0), now = lift((n + 1) / 60.0);
    TestType y = x, w = v + 5;
    shelf::bounce_step(y, w, down, h, before, now, product);
    CAPTURE(n);
    REQUIRE(std::abs(w - (v + 5 + down * h)) < TestType(1e-4));
    shelf::bounce_step(x, v, down, h, before, now, product);
  }
}

TEST_CASE("A lift that stops at once throws up who stands on it") {
  const auto product = [](double a, double b) { return a * b; };
  double height = 0, x = 0, v = 3, most = 0;
  for (int n = 0; n < 120; ++n) {
    const double speed = n < 60 ? 3 : 0, before = height;
    height += speed / 60;
    shelf::bounce_step(
        x, v, -9.81, 1 / 60.0, shelf::MovingPlane<double, double>{{1, 0, 0, 0, 0.5}, before, speed},
        shelf::MovingPlane<double, double>{{1, 0, 0, 0, 0.5}, height, speed}, product);
    most = std::max(most, x - height);
  }
  CHECK(std::abs(most - 3 * 3 / (2 * 9.81)) < 0.03);
}
