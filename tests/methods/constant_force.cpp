// SPDX-License-Identifier: MIT-0
// Under a constant force, where every error can be worked out by hand.
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>
#include <type_traits>
#include <typeinfo>

#include "measure/methods.h"
#include "measure/run.h"
#include "scenes/linear_drag.h"
#include "theory.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using scenes::LinearDrag;

namespace {

constexpr double v0 = 20;
constexpr LinearDrag<> fall{.c = 0, .v0 = v0};
constexpr double a = -fall.g;

struct Miss {
  double position, velocity;
  double rounding;  // of either: each step rounds a few times what has been reached by then
};

template <class Step>
Miss miss(const Step& step, double h, int steps) {
  const double t = h * steps;
  const auto end = measure::after(step, fall, fall.start(), h, steps);
  const auto truth = fall.exact(t);
  // Position Verlet's velocity is a difference of positions, over h.
  const double size = v0 * t + std::abs(a) * t * t + v0 + std::abs(a) * t;
  const double rounding =
      4 * steps * std::numeric_limits<double>::epsilon() * size / std::min(h, 1.0);
  return {end.x - truth.x, end.v - truth.v, rounding};
}

// How far ahead the position is, in a h t: whether a step moves with the velocity of its start, of
// its middle or of its end. In ten steps that is a tenth of what the free fall is off.
template <class Method>
constexpr double lead(Method) {
  return (Method::free_fall_after_ten_steps - 50) / 10.0;
}

// BDF2's start leads once, and not with every step; tests/methods/engines.cpp has by how much.
constexpr auto moves_alike = [](auto method) {
  return !std::is_base_of_v<measure::KeepsLastState, decltype(method)>;
};

// How far ahead the velocity is, in a h.
constexpr double lead_of_velocity(
    theory::OneOf<measure::StormerVerlet, measure::StormerVerletDistance,
                  measure::StormerVerletUneven> auto) {
  return -0.5;
}
constexpr double lead_of_velocity(auto) {
  return 0;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE(
    "Under constant force a position leads by half a h t, or lags by it, or is exact", "",
    list::Where<moves_alike>) {
  INFO(typeid(TestType).name());
  for (const double h : {1.0 / 60, 0.25, 30.0}) {
    for (const int steps : {1, 7, 100}) {
      CAPTURE(h, steps);
      const auto [position, velocity, rounding] = miss(TestType(), h, steps);
      CHECK_THAT(position, WithinAbs(lead(TestType()) * a * h * (h * steps), rounding));
    }
  }
}

TEMPLATE_LIST_TEST_CASE(
    "Under constant force a velocity is exact, but position Verlet's half a step late", "",
    list::General) {
  INFO(typeid(TestType).name());
  for (const double h : {1.0 / 60, 0.25, 30.0}) {
    for (const int steps : {1, 7, 100}) {
      CAPTURE(h, steps);
      const auto [position, velocity, rounding] = miss(TestType(), h, steps);
      CHECK_THAT(velocity, WithinAbs(lead_of_velocity(TestType()) * a * h, rounding));
    }
  }
}

TEST_CASE("With gravity and drag the velocity of linear_damping_exact is exact") {
  for (const double c : {0.1, 2.0, 50.0}) {
    for (const double h : {1.0 / 60, 0.25, 30.0}) {
      CAPTURE(c, h);
      const LinearDrag<> leaf{.c = c, .v0 = v0};
      const int steps = 7;
      const auto end = measure::after(measure::linear_damping_exact, leaf, leaf.start(), h, steps);
      CHECK_THAT(end.v, WithinRel(leaf.exact(h * steps).v, 1e-13));
    }
  }
}

TEST_CASE("With gravity and drag every other way to damp has a velocity of order one") {
  const LinearDrag<> leaf{.c = 2, .v0 = v0};
  const auto end_error = [&leaf](const auto& step, int steps) {
    const auto end = measure::after(step, leaf, leaf.start(), 1.0 / steps, steps);
    return std::abs(end.v - leaf.exact(1.0).v);
  };
  const auto check = [&end_error](const auto& step) {
    CHECK_THAT(std::log2(end_error(step, 400) / end_error(step, 800)), WithinAbs(1, 0.1));
  };
  check(measure::linear_damping_explicit_last);
  check(measure::linear_damping_explicit_first);
  check(measure::linear_damping_implicit_last);
  check(measure::linear_damping_implicit_first);
  check(measure::linear_damping_exponential_last);
  check(measure::linear_damping_exponential_first);
}
