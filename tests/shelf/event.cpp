// SPDX-License-Identifier: MIT-0
#include "shelf/event.h"

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

using Catch::Matchers::WithinAbs;

namespace {

// A state that is its time, and what is asked of it.
template <class Real>
const auto go = [](Real& t, Real h) { t = t + h; };

template <class Real>
shelf::Crossing<Real> first(Real h, const std::function<Real(Real)>& event, int parts = 1) {
  return shelf::first_crossing(Real(0), h, go<Real>, event, parts);
}

}  // namespace

TEMPLATE_TEST_CASE("A crossing is where it is, and never before", "", float, double) {
  using Real = TestType;
  const Real h = Real(0.25), epsilon = std::numeric_limits<Real>::epsilon();
  for (int i = 1; i <= 40; ++i) {
    const Real at = h * Real(i) / Real(40);
    const std::vector<std::function<Real(Real)>> events{
        [at](Real t) { return at - t; },
        [at](Real t) { return Real(1e-9) * (at - t); },
        [at](Real t) { return (at - t) * (at - t) * (at - t); },
        [at](Real t) { return std::exp(20 * (at - t)) - 1; },
        [at](Real t) { return t < at ? Real(1) : Real(-1e6); },
        [at](Real t) { return std::sqrt(std::abs(at - t)) * (t < at ? Real(1) : Real(-1)); }};
    for (const auto& event : events) {
      const auto found = first(h, event);
      REQUIRE(found.found);
      CHECK(event(found.time) <= 0);
      CHECK(found.time <= h);
      const bool is_flat = &event == &events[2];  // whose cube is nothing for a while
      CHECK_THAT(found.time, WithinAbs(at, is_flat ? h * Real(0.01) : 8 * epsilon * h));
    }
  }
}

TEST_CASE("What is not met, or is over already, is none") {
  CHECK_FALSE(first<double>(0.1, [](double) { return 1.0; }).found);
  CHECK_FALSE(first<double>(0.1, [](double t) { return 1e-9 + t; }).found);
  CHECK_FALSE(first<double>(0.1, [](double t) { return -t; }).found);
  CHECK_FALSE(first<double>(0.1, [](double t) { return t - 1; }).found);
  CHECK_FALSE(first<double>(0.1, [](double) { return std::nan(""); }).found);
  CHECK_FALSE(first<double>(0.0, [](double t) { return 1 - t; }).found);
}

TEST_CASE("In its parts the first of several is found") {
  const auto waves = [](double t) { return std::cos(10 * t); };
  const double pi = std::acos(-1.0);
  CHECK_FALSE(first<double>(pi / 5, waves).found);
  CHECK_THAT(first<double>(pi / 5, waves, 2).time, WithinAbs(pi / 20, 1e-15));
  CHECK_THAT(first<double>(3 * pi / 10, waves, 3).time, WithinAbs(pi / 20, 1e-15));
}

TEST_CASE("It asks for few steps, and never for many") {
  for (const auto& [event, most] : std::vector<std::pair<std::function<double(double)>, int>>{
           {[](double t) { return 0.07 - t; }, 8},
           {[](double t) { return std::exp(-t) - 0.95; }, 16},
           {[](double t) { return t < 0.07 ? 1e9 : -1e-9; }, 200}}) {
    int asked = 0;
    const auto step = [&](double& t, double h) { ++asked, t = t + h; };
    CHECK(shelf::first_crossing(0.0, 0.1, step, event).found);
    CHECK(asked <= most);
  }
}
