// SPDX-License-Identifier: MIT-0
// Dormand and Prince's method between the ends of its steps, and in frames that cut none of them.
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "integrate/dopri5.h"
#include "measure/evaluations.h"
#include "measure/length.h"
#include "reference.h"
#include "scenes/orbit.h"
#include "textbook/runge_kutta.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const textbook::Pushed pushed;

constexpr auto size = [](const auto& x) { return measure::length(x); };

// The weights of the slopes at a part of the step, as Hairer, Norsett and Wanner have them (1993,
// II.6.12), but with the last factor of each at the middle of the step: so it is of degree four.
textbook::Row weights_at(long double part) {
  const long double cubic = part * part * (3 - 2 * part), left = 1 - part;
  const long double hump = part * part * left * left;
  return {cubic * 35 / 384 + part * left * left -
              hump * 5 * (2558722523.0L - 31403016 / 2.0L) / 11282082432,
          0,
          cubic * 500 / 1113 + hump * 100 * (882725551 - 15701508 / 2.0L) / 32700410799,
          cubic * 125 / 192 - hump * 25 * (443332067 - 31403016 / 2.0L) / 1880347072,
          -cubic * 2187 / 6784 + hump * 32805 * (23143187 - 3489224 / 2.0L) / 199316789632,
          cubic * 11 / 84 - hump * 55 * (29972135 - 7076736 / 2.0L) / 822651844,
          -part * part * left + hump * 10 * (7414447 - 829305 / 2.0L) / 29380423};
}

// How far a step from the middle of a motion is off on its way, in position or in velocity.
double error_in_a_step(long double h, long double part) {
  const scenes::State<long double> s{0.7L, -1.1L};
  const long double t = 2.3L, at = t + part * h;
  auto path = integrate::dopri5_path(s.x, s.v, t, 1.0L, pushed);
  integrate::dopri5(path, h, pushed);
  const auto truth = reference::after(pushed, s, t, at);
  return double(
      std::max(std::abs(path.position(at) - truth.x), std::abs(path.velocity(at) - truth.v)));
}

using Planet = measure::Counted<scenes::Orbit<>>;

// A planet read in even frames, from the way out through the pericentre.
struct Watched {
  std::vector<scenes::State<scenes::Orbit<>::Vec>> frames;
  integrate::Dopri5Path<scenes::Orbit<>::Vec, double, double> path;
  long evaluations = 0;
  double error = 0;         // in the frames, at most
  double error_at_end = 0;  // at the ends of the steps
};

Watched watch(double duration, int frames, double tolerance) {
  const Planet planet{scenes::Orbit<>()};
  const double begin = 1.3;
  const auto s = planet.exact(begin);
  Watched seen{{}, integrate::dopri5_path(s.x, s.v, 0.0, 0.1, planet)};
  for (int n = 1; n <= frames; ++n) {
    const double t = duration * n / frames;
    REQUIRE(integrate::dopri5_adaptive(seen.path, t, planet, size, tolerance));
    seen.frames.push_back({seen.path.position(t), seen.path.velocity(t)});
    const auto truth = planet.exact(begin + t);
    seen.error = std::max({seen.error, size(scenes::Orbit<>::Vec(seen.frames.back().x - truth.x)),
                           size(scenes::Orbit<>::Vec(seen.frames.back().v - truth.v))});
    const auto end = planet.exact(begin + seen.path.t);
    seen.error_at_end =
        std::max({seen.error_at_end, size(scenes::Orbit<>::Vec(seen.path.x - end.x)),
                  size(scenes::Orbit<>::Vec(seen.path.v - end.v))});
  }
  seen.evaluations = planet.evaluations;
  return seen;
}

}  // namespace

TEMPLATE_TEST_CASE("Between its ends a step of Dormand and Prince is the textbook's polynomial", "",
                   double, float) {
  const TestType x = TestType(0.7), v = TestType(-1.1), t = TestType(2.3);
  for (const TestType h : {TestType(0.9), TestType(-0.9)}) {
    auto path = integrate::dopri5_path(x, v, t, TestType(1), pushed);
    integrate::dopri5(path, h, pushed);
    const auto table = textbook::table(measure::Dopri5());
    const auto slopes = textbook::stages(table, pushed, {x, v}, t, h);
    for (const TestType part : {TestType(0.125), TestType(0.5), TestType(0.8125)}) {
      const TestType at = t + part * h;
      const textbook::Pair moved =
          (long double)h * textbook::sum(weights_at((at - (long double)t) / h), slopes);
      const double rounding = 64 * double(std::numeric_limits<TestType>::epsilon());
      CHECK_THAT(path.position(at), WithinAbs(double(x + moved[0]), rounding));
      CHECK_THAT(path.velocity(at), WithinAbs(double(v + moved[1]), rounding));
    }
  }
}

// In one step order 4 errs by h^5.
TEST_CASE("Between the ends of a step the path of Dormand and Prince has order 4") {
  for (const long double part : {0.25L, 0.5L, 0.8L}) {
    for (const long double sign : {1.0L, -1.0L}) {
      double coarse = error_in_a_step(sign / 32, part);
      for (const long double h : {sign / 64, sign / 128, sign / 256}) {
        const double fine = error_in_a_step(h, part);
        CAPTURE(double(part), double(h), fine);
        CHECK_THAT(std::log2(coarse / fine), WithinAbs(5, 0.1));
        coarse = fine;
      }
      CHECK(coarse > 1e3 * double(std::numeric_limits<long double>::epsilon()));
    }
  }
}

TEMPLATE_TEST_CASE("A path of Dormand and Prince is whole where one step ends and the next begins",
                   "", double, float) {
  using Vec = Eigen::Matrix<TestType, 3, 1>;
  const auto force = [](const Vec& x, const Vec& v, double t) {
    return Vec(TestType(-4) * x + TestType(-0.25) * v + TestType(std::cos(3 * t)) * Vec::Ones());
  };
  // Of the numbers, which are the largest at one end or the other, and of the clock.
  const auto rounding = [](double t, const Vec& y, const Vec& slope) {
    return 32 * std::numeric_limits<TestType>::epsilon() * y.norm() +
           TestType(4 * std::numeric_limits<double>::epsilon() * std::abs(t)) * slope.norm();
  };
  for (const TestType h : {TestType(0.1), TestType(-0.1)}) {
    auto path = integrate::dopri5_path(Vec(1, -2, 3), Vec(0.5, 0.25, -1), 5.0, h, force);
    CHECK(path.holds(5));
    CHECK_FALSE((path.holds(5 + 1e-9) || path.holds(5 - 1e-9)));
    CHECK(path.position(5) == Vec(1, -2, 3));
    CHECK(path.velocity(5) == Vec(0.5, 0.25, -1));
    for (int n = 0; n < 50; ++n) {
      const auto before = path;
      integrate::dopri5(path, h * TestType(1 + n % 3), force);
      CHECK((path.holds(before.t) && path.holds(path.t) && path.t != before.t));
      CHECK(path.position(before.t) == before.x);
      CHECK(path.velocity(before.t) == before.v);
      CHECK((path.position(path.t) - path.x).norm() < rounding(path.t, path.x, path.v));
      CHECK((path.velocity(path.t) - path.v).norm() < rounding(path.t, path.v, path.a));
    }
  }
}

TEST_CASE("A step along a path is the step of Dormand and Prince, to the last bit") {
  auto path = integrate::dopri5_path(0.7, -1.1, 2.3, 1.0, pushed);
  double x = 0.7, v = -1.1, t = 2.3, a = integrate::dopri5_start(x, v, t, pushed);
  for (const double h : {0.5, 0.3, -0.7}) {
    const auto error = integrate::dopri5(x, v, a, t, h, pushed);
    const auto along = integrate::dopri5(path, h, pushed);
    t += h;
    CHECK((path.x == x && path.v == v && path.a == a && path.t == t && path.h == 1));
    CHECK((along.x == error.x && along.v == error.v));
  }
}

TEST_CASE("Frames of any length cut no step of Dormand and Prince and cost nothing") {
  for (const double duration : {8.75, -8.75}) {
    const Watched once = watch(duration, 1, 1e-8), often = watch(duration, 600, 1e-8);
    CHECK((once.path.x == often.path.x && once.path.v == often.path.v));
    CHECK((once.path.t == often.path.t && once.path.h == often.path.h));
    CHECK(once.frames.back().x == often.frames.back().x);
    CHECK(once.evaluations == often.evaluations);

    const Planet alone{scenes::Orbit<>()};
    auto s = alone.exact(1.3);
    double h = 0.1;
    REQUIRE(integrate::dopri5_adaptive(s.x, s.v, 0.0, duration, h, alone, size, 1e-8));
    CHECK(once.evaluations == alone.evaluations);
    CHECK(size(scenes::Orbit<>::Vec(once.frames[0].x - s.x)) < 1e-7);
  }
}

// Nothing of the polynomial is left to see but a part of what the steps themselves are off.
TEST_CASE("In frames Dormand and Prince err hardly more than at the ends of their steps") {
  for (const double duration : {8.75, -8.75}) {
    for (double tolerance = 1e-3; tolerance > 0.9e-13; tolerance /= 10) {
      const Watched seen = watch(duration, 600, tolerance);
      CAPTURE(duration, tolerance, seen.error, seen.error_at_end);
      CHECK(seen.error < 1.25 * seen.error_at_end);
      CHECK(seen.error_at_end < 1000 * tolerance);
      CHECK(seen.error_at_end > tolerance);
    }
  }
}

TEST_CASE("A path of Dormand and Prince turns back to a time that lies behind it") {
  const auto spring = [](double x, double, double) { return -4 * x; };
  auto path = integrate::dopri5_path(1.0, 0.0, 0.0, 0.1, spring);
  for (const double t : {3.0, 2.9, 0.5, -1.0, 3.0}) {
    REQUIRE(integrate::dopri5_adaptive(path, t, spring, size, 1e-10));
    CHECK(path.holds(t));
    CHECK_THAT(path.position(t), WithinAbs(std::cos(2 * t), 1e-8));
    CHECK_THAT(path.velocity(t), WithinAbs(-2 * std::sin(2 * t), 1e-8));
  }
}

TEST_CASE("Where there is no way on, a path of Dormand and Prince ends and says so") {
  const auto spring = [](double x, double, double) { return -x; };
  auto path = integrate::dopri5_path(1.0, -0.5, 0.0, 0.1, spring);
  const auto refuses = [&path](double t, auto force, double tolerance = 1e-8) {
    return !integrate::dopri5_adaptive(path, t, force, size, tolerance);
  };
  SECTION("a time that is not a number, or infinite") {
    for (const double t : {double(NAN), double(INFINITY), -double(INFINITY)}) {
      CHECK(refuses(t, spring));
      CHECK((path.x == 1 && path.v == -0.5 && path.t == 0 && path.h == 0.1));
    }
  }
  SECTION("the acceleration is not a number from some time on") {
    CHECK(refuses(2, [](double x, double, double t) { return t > 0.5 ? double(NAN) : -x; }));
    CHECK_THAT(path.t, WithinAbs(0.5, 1e-6));
    CHECK_THAT(path.x, WithinAbs(std::cos(path.t) - 0.5 * std::sin(path.t), 1e-6));
  }
  SECTION("a fall into a centre that pulls without bounds") {
    CHECK(refuses(2, [](double x, double, double) { return -1 / (x * x); }));
    CHECK((path.x > 0 && path.x < 1e-3 && path.t > 0.5));
  }
  SECTION("more steps than it may try") {
    CHECK_FALSE(integrate::dopri5_adaptive(path, 100.0, spring, size, 1e-8, 20));
    CHECK((path.t > 1 && path.t < 100));
    CHECK_THAT(path.x, WithinAbs(std::cos(path.t) - 0.5 * std::sin(path.t), 1e-6));
    CHECK(integrate::dopri5_adaptive(path, 100.0, spring, size, 1e-8));
  }
  SECTION("a tolerance that no step can keep") {
    CHECK(refuses(2, [](double x, double, double t) { return std::cos(3 * t) - x; }, 0.0));
    CHECK((path.x == 1 && path.t == 0));
  }
  SECTION("a first step of no length, or of one that is not a number or infinite") {
    for (const double h : {0.0, -0.1, double(NAN), double(INFINITY)}) {
      path.h = h;
      CHECK(refuses(2, spring));
      CHECK(refuses(-2, spring));
      CHECK((path.x == 1 && path.t == 0));
    }
  }
}
