// SPDX-License-Identifier: MIT-0
#include "shelf/bounce.h"

#include <algorithm>
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "three.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double g = 9.81;
constexpr auto times = [](auto p, auto q) { return p * q; };

template <class Real>
using OnALine = shelf::Plane<Real, Real>;

// What is known of a first root in [0, h] of a function that starts above zero: it is above zero
// before, and at or below zero there. Looked for on a grid that does not know the answer.
template <class Height>
struct Looked {
  Height height;
  long double h;

  long double lowest(long double until) const {
    long double low = height(0);
    for (int i = 1; i <= 4000; ++i) low = std::min(low, height(until * i / 4000));
    return low;
  }

  void check(bool hit, long double time, long double allowed) const {
    if (!hit) {
      CHECK(lowest(h) > -allowed);
      return;
    }
    CHECK(time >= 0);
    CHECK(time <= h);
    CHECK(std::abs(height(time)) < allowed);
    CHECK(lowest(time) > -allowed);
  }
};

double energy(double x, double v) {
  return v * v / 2 + g * x;
}

}  // namespace

TEMPLATE_TEST_CASE("A plane is met at the first root of the fall, and not before", "", float,
                   double) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> of(-1, 1);
  int hits = 0, misses = 0;
  for (int n = 0; n < 2000; ++n) {
    const TestType s = TestType(std::abs(of(random))), v = TestType(12 * of(random)),
                   a = TestType(n % 3 ? 40 * of(random) : 0), h = TestType(0.5);
    CAPTURE(s, v, a);
    const auto impact = shelf::impact_plane(s, v, a, h);
    const auto height = [&](long double t) { return s + (v + a * t / 2) * t; };
    const long double allowed = 32 * std::numeric_limits<TestType>::epsilon();
    Looked<decltype(height)>{height, h}.check(impact.hit, impact.time, allowed);
    if (impact.hit) CHECK((long double)v + (long double)a * impact.time <= 1e-2);
    ++(impact.hit ? hits : misses);
  }
  CHECK(hits > 500);
  CHECK(misses > 500);
}

TEMPLATE_TEST_CASE("Slow or nearly straight, the moment of impact keeps its digits", "", float,
                   double) {
  const double rounding = 4 * double(std::numeric_limits<TestType>::epsilon());
  for (const double tiny : {1e-3, 1e-6, 1e-9, 1e-12}) {
    // A fall of 1 m at 1 m/s with next to no acceleration takes 1 - a/2 + a^2/2 - 5 a^3/8 s.
    const auto straight =
        shelf::impact_plane(TestType(1), TestType(-1), TestType(-tiny), TestType(2));
    CHECK_THAT(double(straight.time), WithinRel(1 - tiny / 2 * (1 - tiny * (1 - 1.25 * tiny)),
                                                rounding + std::pow(tiny, 4)));
    // Thrown up from the plane: back after 2 v / g, however slow.
    const auto thrown =
        shelf::impact_plane(TestType(0), TestType(tiny), TestType(-10), TestType(2));
    CHECK_THAT(double(thrown.time), WithinRel(double(TestType(tiny)) / 5, rounding));
    // Just above it, falling from rest.
    const auto let_go = shelf::impact_plane(TestType(tiny), TestType(0), TestType(-2), TestType(2));
    CHECK_THAT(double(let_go.time), WithinRel(std::sqrt(double(TestType(tiny))), rounding));
  }
}

TEST_CASE("What goes away from a plane, or is not a number, does not meet it") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(shelf::impact_plane(1.0, 2.0, 3.0, 10.0).hit);
  CHECK_FALSE(shelf::impact_plane(1.0, 0.0, 0.0, 10.0).hit);
  CHECK_FALSE(shelf::impact_plane(0.0, 0.0, 0.0, 10.0).hit);
  CHECK_FALSE(shelf::impact_plane(0.0, 1.0, 0.0, 10.0).hit);
  CHECK_FALSE(shelf::impact_plane(-1.0, 1.0, 0.0, 10.0).hit);
  CHECK_FALSE(shelf::impact_plane(1.0, -1.0, 10.0, 10.0).hit);  // turns 5 cm below its start
  CHECK_FALSE(shelf::impact_plane(1.0, -1.0, 0.0, 0.999).hit);
  CHECK(shelf::impact_plane(1.0, -1.0, 0.0, 1.0).hit);
  CHECK(shelf::impact_plane(0.0, 0.0, -1.0, 1.0).hit);
  CHECK(shelf::impact_plane(-1.0, -1.0, 5.0, 1.0).time == 0);
  CHECK_FALSE(shelf::impact_plane(nan, -1.0, 0.0, 1.0).hit);
  CHECK_FALSE(shelf::impact_plane(1.0, nan, 0.0, 1.0).hit);
  CHECK_FALSE(shelf::impact_plane(1.0, -1.0, nan, 1.0).hit);
  CHECK_FALSE(shelf::impact_plane(1.0, -1.0, 0.0, nan).hit);
}

TEMPLATE_TEST_CASE("A sphere is met at the first root of the way, straight or bent", "", float,
                   double) {
  using Vec = Three<TestType>;
  std::mt19937 random(13);
  std::uniform_real_distribution<double> of(-1, 1);
  const auto vector = [&](double most) {
    return Vec{TestType(most * of(random)), TestType(most * of(random)),
               TestType(most * of(random))};
  };
  int hits = 0, misses = 0;
  for (int n = 0; n < 600; ++n) {
    const Vec x = vector(3), v = vector(4) + TestType(-3) * x, a = vector(60);
    const TestType radius = TestType(0.2 + std::abs(of(random))), h = TestType(0.5);
    if (norm(x) < radius) continue;
    const auto straight = shelf::impact_sphere(x, v, radius, h, dot);
    const auto bent = shelf::impact_sphere(x, v, a, radius, h, dot);
    const auto outside = [&](long double bend) {
      return [&, bend](long double t) {
        return norm(exactly(x) + t * exactly(v) + (bend * t * t / 2) * exactly(a)) - radius;
      };
    };
    // The way is 10 m long and more, and the quartic holds its square.
    const long double allowed = 2000 * std::numeric_limits<TestType>::epsilon();
    CAPTURE(n);
    const auto on_the_line = outside(0), on_the_bow = outside(1);
    Looked<decltype(on_the_line)>{on_the_line, h}.check(straight.hit, straight.time, allowed);
    Looked<decltype(on_the_bow)>{on_the_bow, h}.check(bent.hit, bent.time, allowed);
    hits += straight.hit + bent.hit;
    misses += !straight.hit + !bent.hit;
    const auto unbent = shelf::impact_sphere(x, v, TestType(0) * a, radius, h, dot);
    CHECK(unbent.hit == straight.hit);
    CHECK(std::abs(unbent.time - straight.time) < allowed);
  }
  CHECK(hits > 100);
  CHECK(misses > 100);
}

TEMPLATE_TEST_CASE("A bullet meets a far ball, and just misses it, to rounding of the way", "",
                   float, double) {
  using Vec = Three<TestType>;
  const TestType h = 1, radius = TestType(0.5);
  for (const double way : {10.0, 1e3, 1e5}) {
    const Vec v{TestType(2 * way), 0, 0};
    const auto aside = [&](double miss) { return Vec{TestType(-way), TestType(miss), 0}; };
    const auto through = shelf::impact_sphere(aside(0.3), v, radius, h, dot);
    CHECK(through.hit);
    CHECK_THAT(double(through.time) * 2 * way,
               WithinAbs(way - 0.4, 8 * way * double(std::numeric_limits<TestType>::epsilon())));
    CHECK(shelf::impact_sphere(aside(0.4999), v, radius, h, dot).hit);
    CHECK_FALSE(shelf::impact_sphere(aside(0.5001), v, radius, h, dot).hit);
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(shelf::impact_sphere(nan, 1.0, 0.5, 1.0, times).hit);
  CHECK_FALSE(shelf::impact_sphere(-2.0, nan, 0.5, 1.0, times).hit);
  CHECK_FALSE(shelf::impact_sphere(-2.0, nan, 1.0, 0.5, 1.0, times).hit);
  CHECK_FALSE(shelf::impact_sphere(-2.0, 0.0, 0.5, 1.0, times).hit);
  CHECK_FALSE(shelf::impact_sphere(-2.0, 0.0, 0.0, 0.5, 1.0, times).hit);
}

TEST_CASE("What is inside a sphere meets it at once, unless it is on its way out") {
  CHECK(shelf::impact_sphere(-0.2, 1.0, 0.5, 1.0, times).hit);
  CHECK(shelf::impact_sphere(-0.2, 1.0, 0.0, 0.5, 1.0, times).hit);
  CHECK(shelf::impact_sphere(-0.2, 1.0, 0.5, 1.0, times).time == 0);
  CHECK_FALSE(shelf::impact_sphere(-0.2, -1.0, 0.5, 1.0, times).hit);
  CHECK_FALSE(shelf::impact_sphere(-0.2, -1.0, 0.0, 0.5, 1.0, times).hit);
  // Out at 2 m/s and drawn back by 8 m/s^2: at the surface again after 1/2 s from there.
  const auto back = shelf::impact_sphere(-0.5, -2.0, 8.0, 0.5, 1.0, times);
  CHECK(back.hit);
  CHECK_THAT(back.time, WithinAbs(0.5, 1e-12));
}

TEMPLATE_TEST_CASE("A bounce gives back its share of the speed into the plane, and no other", "",
                   float, double) {
  using Vec = Three<TestType>;
  const Vec normal{0, TestType(0.6), TestType(0.8)}, along{1, 0, 0};
  const TestType zero = 0;
  for (const double share : {0.0, 0.3, 1.0}) {
    Vec v = TestType(-5) * normal + TestType(2) * along;
    const TestType push = shelf::bounce(v, normal, TestType(share), TestType(1), dot);
    CHECK_THAT(double(push), WithinRel(5 * (1 + share), 1e-6));
    CHECK(apart(exactly(v), exactly(TestType(5 * share) * normal + TestType(2) * along)) < 1e-5);
    const Vec after = v;
    CHECK((share == 0 || shelf::bounce(v, normal, TestType(share), TestType(1), dot) == zero));
    CHECK((share == 0 || v == after));
  }
  Vec slow = TestType(-0.99) * normal;
  shelf::bounce(slow, normal, TestType(1), TestType(1), dot);
  CHECK(norm(slow) < TestType(1e-6));
  Vec fast = TestType(-1.01) * normal;
  shelf::bounce(fast, normal, TestType(1), TestType(1), dot);
  CHECK(norm(fast) > TestType(1));
}

TEMPLATE_TEST_CASE("Friction takes what it may and stops what it can", "", float, double) {
  using Vec = Three<TestType>;
  const Vec up{0, 0, 1};
  Vec v{3, 4, 7};
  shelf::friction(v, up, TestType(1), dot);
  CHECK(apart(exactly(v), Long{2.4L, 3.2L, 7}) < 1e-6);
  shelf::friction(v, up, TestType(4.5), dot);
  CHECK(v == Vec{0, 0, 7});
  shelf::friction(v, up, TestType(1), dot);
  CHECK(v == Vec{0, 0, 7});
  shelf::friction(v, up, TestType(0), dot);
  CHECK(v == Vec{0, 0, 7});
}

TEMPLATE_TEST_CASE("A hundred bounces keep the energy, at any step and at uneven ones", "", float,
                   double) {
  const double allowed = 400 * double(std::numeric_limits<TestType>::epsilon());
  const OnALine<TestType> floor{1, 0, 1, 0, 0};
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uneven(0.001, 0.1);
  for (const double step : {1 / 15.0, 1 / 60.0, 1 / 144.0, 0.0}) {
    TestType x = 2, v = 0;
    int bounces = 0;
    while (bounces < 100) {
      const TestType h = TestType(step > 0 ? step : uneven(random));
      bounces += shelf::bounce_step(x, v, TestType(-g), h, floor, times);
      REQUIRE_THAT(energy(double(x), double(v)) / (2 * g), WithinAbs(1, allowed));
      REQUIRE(x >= 0);
    }
  }
}

TEST_CASE("In seconds each bounce comes when it is due, whatever the step") {
  // Dropped from 2 m, it lands after sqrt(4/g); up again at 0.8 of the speed, for 0.8 of twice
  // that.
  const OnALine<double> floor{1, 0, 0.8, 0, 0.1};
  for (const double h : {1 / 15.0, 1 / 60.0, 1 / 144.0}) {
    double x = 2, v = 0;
    int bounces = 0;
    const double fall = std::sqrt(4 / g);
    for (int n = 1; n * h < 4.5; ++n) {
      bounces += shelf::bounce_step(x, v, -g, h, floor, times);
      double up = fall, length = 2 * 0.8 * fall;
      int due = 0;
      for (; up < n * h; up += length, length *= 0.8) ++due;
      REQUIRE(bounces == due);
      const double speed = g * fall * std::pow(0.8, due), since = n * h - (up - length / 0.8);
      const double height = due == 0 ? 2 - g * n * h * n * h / 2 : (speed - g * since / 2) * since;
      CHECK_THAT(x, WithinAbs(height, 1e-12));
    }
  }
}

TEMPLATE_TEST_CASE("Slower than the threshold, a ball comes to rest and stays to the bit", "",
                   float, double) {
  using Vec = Three<TestType>;
  const shelf::Plane<Vec, TestType> floor{
      {0, 0, 1}, TestType(0.25), TestType(0.6), TestType(0.3), TestType(0.5)};
  Vec x{0, 0, 3}, v{TestType(1.5), TestType(-0.7), 0};
  const auto step = [&] {
    return shelf::bounce_step(x, v, Vec{0, 0, TestType(-g)}, TestType(1) / 60, floor, dot);
  };
  int bounces = 0;
  for (int n = 0; n < 600; ++n) bounces += step();
  const Vec rest = x;
  CHECK(bounces == 6);  // 7.35 m/s at first, then 0.6 of it, and 0.57 at the sixth
  CHECK_THAT(double(x.z), WithinAbs(0.25, double(std::numeric_limits<TestType>::epsilon())));
  for (int n = 0; n < 600; ++n) {
    CHECK(step() == 0);
    CHECK(v == Vec{0, 0, 0});
    CHECK(x == rest);
  }
}

TEST_CASE("A puck slides v^2 / (2 mu g) and stops, within mu g h^2 / 8") {
  using Vec = Three<double>;
  for (const double h : {1 / 30.0, 1 / 60.0, 0.013}) {
    for (const double mu : {0.02, 0.1, 0.7}) {
      for (const double speed : {0.01, 1.0, 6.0}) {
        CAPTURE(h, mu, speed);
        const shelf::Plane<Vec, double> ice{{0, 0, 1}, 0, 0.5, mu, 1};
        Vec x{0, 0, 0}, v{0.6 * speed, -0.8 * speed, 0};
        int steps = 0;
        for (; norm(v) > 0; ++steps) {
          REQUIRE(steps < 100'000);
          shelf::bounce_step(x, v, Vec{0, 0, -g}, h, ice, dot);
        }
        const double way = speed * speed / (2 * mu * g);
        CHECK_THAT(norm(x), WithinAbs(way, mu * g * h * h / 8 + 1e-12));
        CHECK(std::abs(steps - speed / (mu * g * h)) <= 1 + 1e-9);
        CHECK_THAT(x.x / norm(x), WithinAbs(0.6, 1e-12));
      }
    }
  }
}

TEST_CASE("On a slope friction holds up to its angle, and beyond it the right push is left") {
  using Vec = Three<double>;
  const double mu = 0.4;
  for (const double angle : {0.1, 0.37, 0.39, 0.8}) {  // tan 0.3805 is 0.4
    CAPTURE(angle);
    const shelf::Plane<Vec, double> slope{{std::sin(angle), 0, std::cos(angle)}, 0, 0.5, mu, 1};
    Vec x{0, 0, 0}, v{0, 0, 0};
    for (int n = 0; n < 60; ++n) shelf::bounce_step(x, v, Vec{0, 0, -g}, 1 / 60.0, slope, dot);
    const double push = g * (std::sin(angle) - mu * std::cos(angle));
    CHECK_THAT(norm(v), WithinAbs(std::max(0.0, push), 1e-12));
    CHECK_THAT(norm(x), WithinAbs(std::max(0.0, push) / 2, 1e-12));
  }
}

TEST_CASE("Fast or deep, nothing gets through: a bullet in one step, a ball that began below") {
  const OnALine<double> floor{1, 0, 0.5, 0, 1};
  double x = 1, v = -1e6;
  CHECK(shelf::bounce_step(x, v, -g, 0.25, floor, times) == 1);
  CHECK(x > 0);
  CHECK_THAT(v, WithinRel(5e5, 1e-5));
  x = -3, v = 0;
  shelf::bounce_step(x, v, -g, 0.25, floor, times);
  CHECK(x == 0);
  CHECK(v == 0);
}

TEST_CASE("Bounces that come closer and closer end, in one step of a second too") {
  for (const double share : {0.0, 0.5, 0.99, 1.0}) {
    for (const double threshold : {0.0, 0.5}) {
      const OnALine<double> floor{1, 0, share, 0, threshold};
      double x = 1e-3, v = 0;
      for (int n = 0; n < 100; ++n) {
        CHECK(shelf::bounce_step(x, v, -g, 1.0, floor, times) <= 64);
        CHECK(x >= 0);
        CHECK(energy(x, v) <= g * 1.001e-3);
      }
    }
  }
}

TEST_CASE("Drawn to a ceiling, a balloon bounces off it and floats away when gravity turns") {
  const OnALine<double> ceiling{-1, -3, 0.5, 0, 0.2};  // at a height of 3
  double x = 2, v = 0;
  for (int n = 0; n < 600; ++n) shelf::bounce_step(x, v, 0.5, 1 / 60.0, ceiling, times);
  CHECK(x == 3);
  CHECK(v == 0);
  for (int n = 0; n < 60; ++n) shelf::bounce_step(x, v, -0.5, 1 / 60.0, ceiling, times);
  CHECK_THAT(x, WithinAbs(2.75, 1e-12));
}

TEMPLATE_TEST_CASE("What leaves the plane as slowly as can be is let go", "", float, double) {
  const OnALine<TestType> plane{1, 0, TestType(0.5), 0, TestType(0.5)};
  const TestType h = TestType(1) / 60, away = TestType(g);
  const TestType least = std::numeric_limits<TestType>::denorm_min();
  for (const TestType speed : {least, -least, TestType(0), TestType(0.1), TestType(-0.1)}) {
    CAPTURE(speed);
    TestType x = 0, v = speed;
    shelf::bounce_step(x, v, away, h, plane, times);
    const double start = std::max(0.0, double(speed));
    CHECK_THAT(x, WithinRel(start * h + 0.5 * double(away) * h * h, 1e-5));
    CHECK_THAT(v, WithinRel(start + double(away) * h, 1e-5));
  }
  CHECK_FALSE(shelf::impact_plane(TestType(0), least, away, h).hit);
}

TEMPLATE_TEST_CASE("From as near as can be nothing falls through the plane", "", float, double) {
  const TestType start = std::numeric_limits<TestType>::denorm_min(), down = TestType(-0.1);
  TestType x = start, v = 0;
  shelf::bounce_step(x, v, down, TestType(10), OnALine<TestType>{1, 0, 0, 0, 0}, times);
  CHECK(x == start);
  CHECK(v == 0);
}

TEST_CASE("What is not a number meets nothing") {
  for (int which = 0; which < 4; ++which) {
    CAPTURE(which);
    double in_plane[] = {-1, -1, -g, 0.1}, in_sphere[] = {0.5, -1, 1, 0.1};
    CHECK(shelf::impact_plane(in_plane[0], in_plane[1], in_plane[2], in_plane[3]).hit);
    CHECK(shelf::impact_sphere(in_sphere[0], in_sphere[1], in_sphere[2], in_sphere[3], times).hit);
    in_plane[which] = in_sphere[which] = NAN;
    const auto [height, speed, acceleration, h] = in_plane;
    CHECK_FALSE(shelf::impact_plane(height, speed, acceleration, h).hit);
    const auto [x, v, radius, step] = in_sphere;
    CHECK_FALSE(shelf::impact_sphere(x, v, radius, step, times).hit);
    CHECK_FALSE(shelf::impact_sphere(x, v, 0.0, radius, step, times).hit);
  }
  CHECK(shelf::impact_sphere(0.5, -1.0, 0.0, 1.0, 0.1, times).hit);
  CHECK_FALSE(shelf::impact_sphere(0.5, -1.0, double(NAN), 1.0, 0.1, times).hit);
}
