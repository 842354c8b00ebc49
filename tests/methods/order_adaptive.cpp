// SPDX-License-Identifier: MIT-0
// Dormand and Prince's method with error control: what its tolerance means, and what it does where
// there is no way on.
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <vector>

#include "integrate/dopri5.h"
#include "measure/evaluations.h"
#include "measure/length.h"
#include "scenes/orbit.h"
#include "scenes/spring.h"

using Catch::Matchers::WithinRel;

namespace {

constexpr auto size = [](const auto& x) { return measure::length(x); };

struct Run {
  double error;
  long evaluations;
};

// A planet, from the way out through the pericentre, or backwards from there.
template <class Real>
Run orbit(Real duration, Real tolerance) {
  const measure::Counted<scenes::Orbit<Real>> planet{scenes::Orbit<Real>()};
  const Real begin = Real(1.3);
  auto s = planet.exact(begin);
  Real h = Real(0.1);
  const auto norm = [](const auto& x) { return x.norm(); };
  REQUIRE(integrate::dopri5_adaptive(s.x, s.v, Real(0), duration, h, planet, norm, tolerance));
  const auto truth = planet.exact(begin + duration);
  const double in_position = measure::length(s.x - truth.x);
  return {std::max(in_position, measure::length(s.v - truth.v)), planet.evaluations};
}

template <class Scene>
bool moves(double& x, double& v, double duration, double& h, const Scene& scene) {
  return integrate::dopri5_adaptive(x, v, 0.0, duration, h, scene, size, 1e-8);
}

}  // namespace

// A step may be wrong by the tolerance. Some ten to a hundred steps add up, and an orbit spreads
// what is wrong early on; a step of order 5 is less wrong than its estimate of order 4 says.
TEMPLATE_TEST_CASE("Dormand and Prince's error follows the tolerance, forward and back", "", double,
                   float) {
  const double finest = std::is_same_v<TestType, double> ? 1e-13 : 1e-6;
  for (const double duration : {8.75, -8.75}) {
    for (double tolerance = 1e-3; tolerance > 0.9 * finest; tolerance /= 10) {
      const Run run = orbit(TestType(duration), TestType(tolerance));
      CAPTURE(duration, tolerance, run.error / tolerance);
      CHECK(run.error < 100 * tolerance);
      CHECK(run.error > tolerance / 10);
    }
  }
}

TEST_CASE("A hundredth of the tolerance costs Dormand and Prince 10^(2/5) times the evaluations") {
  const double before = double(orbit(8.75, 1e-9).evaluations);
  CHECK_THAT(double(orbit(8.75, 1e-11).evaluations) / before, WithinRel(std::pow(10, 0.4), 0.02));
  CHECK_THAT(double(orbit(8.75, 1e-13).evaluations) / before, WithinRel(std::pow(10, 0.8), 0.02));
}

TEST_CASE("Dormand and Prince begin with the step that they are given and end on time") {
  std::vector<double> asked;
  const auto driven = [&asked](double x, double, double t) {
    asked.push_back(t);
    return std::cos(3 * t) - x;
  };
  for (const double duration : {1.75, -1.75}) {
    asked.clear();
    double x = 1, v = 0, h = 0.125;
    REQUIRE(integrate::dopri5_adaptive(x, v, 5.0, duration, h, driven, size, 1e-6));
    CHECK(asked[0] == 5);
    CHECK_THAT(asked[1], WithinRel(5 + std::copysign(0.125 / 5, duration), 1e-15));
    CHECK(asked.back() == 5 + duration);
    CHECK(std::abs(*std::max_element(asked.begin(), asked.end()) - 5) <= 1.75);
  }
}

TEST_CASE("Dormand and Prince leave the step to try next, whatever the rest of the way was") {
  const scenes::Spring<> spring;
  const measure::Counted<scenes::Spring<>> counted{spring};
  double x = 1, v = 0, h = 1e-9;
  REQUIRE(moves(x, v, 10.0, h, counted));
  const double settled = h;
  CHECK(settled > 0.01);
  CHECK(counted.evaluations < 1500);  // grew by a factor of 5 at a time
  SECTION("the step is kept over an end that comes too soon") {
    REQUIRE(moves(x, v, settled / 100, h, spring));
    CHECK(h == settled);
  }
  SECTION("no way to go changes nothing") {
    const double at = x;
    REQUIRE(moves(x, v, 0.0, h, spring));
    CHECK((x == at && h == settled));
  }
  SECTION("a step that is too large is taken back") {
    x = 1, v = 0, h = 100;
    REQUIRE(moves(x, v, 10.0, h, spring));
    CHECK(h < 2 * settled);
    CHECK_THAT(x, WithinRel(std::cos(10), 1e-6));
  }
}

TEST_CASE("The step that Dormand and Prince leave is nine tenths of what meets the tolerance") {
  const scenes::Spring<> spring{.zeta = 0.1};
  double x = 1, v = 0.5, h = 0.05;
  REQUIRE(moves(x, v, 0.075, h, spring));  // one step in full, and a rest
  double a = spring(x, v, 0.0);
  const auto error = integrate::dopri5(x, v, a, 0.0, h / 0.9, spring);
  CHECK_THAT(std::max(size(error.x), size(error.v)), WithinRel(1e-8, 0.1));
}

TEST_CASE("Where there is no way on, Dormand and Prince say so and move nothing") {
  double x = 1, v = -0.5, h = 0.1;
  SECTION("the acceleration is not a number from some time on") {
    const auto until = [](double at, double, double t) { return t > 0.5 ? double(NAN) : -at; };
    CHECK_FALSE(moves(x, v, 2, h, until));
  }
  SECTION("it is not a number from the start") {
    CHECK_FALSE(moves(x, v, 2, h, [](double, double, double) { return double(NAN); }));
  }
  SECTION("the last stage of the last step is not a number") {
    int asked = 0;
    const auto seventh = [&asked](double at, double, double) {
      return ++asked >= 7 ? double(NAN) : -at;
    };
    CHECK_FALSE(moves(x, v, 0.01, h, seventh));
  }
  SECTION("a duration that is not a number") {
    CHECK_FALSE(moves(x, v, NAN, h, [](double at, double, double) { return -at; }));
  }
  SECTION("a fall into a centre that pulls without bounds") {
    CHECK_FALSE(moves(x, v, 2, h, [](double at, double, double) { return -1 / (at * at); }));
  }
  SECTION("the same back in time, from where it was flung") {
    v = 0.5;
    CHECK_FALSE(moves(x, v, -2, h, [](double at, double, double) { return -1 / (at * at); }));
  }
  SECTION("more steps than it may try") {
    int asked = 0;
    const auto counted = [&asked](double at, double, double) {
      ++asked;
      return -at;
    };
    CHECK_FALSE(integrate::dopri5_adaptive(x, v, 0.0, 100.0, h, counted, size, 1e-8, 20));
    CHECK(asked == 1 + 6 * 20);
  }
  SECTION("a tolerance that no step can keep") {
    const auto driven = [](double at, double, double t) { return std::cos(3 * t) - at; };
    CHECK_FALSE(integrate::dopri5_adaptive(x, v, 0.0, 1.0, h, driven, size, 0.0));
  }
  CHECK(x == 1);
  CHECK(std::abs(v) == 0.5);
}
