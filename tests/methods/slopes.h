// SPDX-License-Identifier: MIT-0
// The order of a method on a problem: how steeply the errors fall with the step.
#pragma once
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "../scenes/equation.h"
#include "measure/run.h"
#include "order_problems.h"

namespace order {

// The numbers that a method's order is measured in. Order 5 falls to double's rounding before its
// slope has settled.
template <class Method>
using Number = std::conditional_t<(Method::order < 5), double, long double>;

struct Errors {
  double position = 0, velocity = 0;
};

// The largest errors at the eight times: at one of them an error can pass through zero.
template <class Step, class Real, class Scene, class Vec>
Errors largest_errors(const Step& step, const Problem<Real, Scene, Vec>& problem, int steps) {
  const Real h = problem.part / Real(steps);
  auto memory = measure::start(step, problem.start, h, problem.scene);
  Errors largest;
  for (int n = 0; n < 8 * steps; ++n) {
    measure::advance(step, memory, Real(n) * h, h, problem.scene);
    if ((n + 1) % steps != 0) continue;
    const auto now = measure::to_state(step, memory, Real(n + 1) * h, h, problem.scene);
    const auto& truth = problem.truth[std::size_t((n + 1) / steps - 1)];
    const double in_position = double(equation::length(Vec(now.x - truth.x)));
    const double in_velocity = double(equation::length(Vec(now.v - truth.v)));
    largest.position = std::max(largest.position, in_position);
    largest.velocity = std::max(largest.velocity, in_velocity);
  }
  return largest;
}

// Halves the step three times. Two-sided: a method is no better than its order, either.
template <class Step, class Real, class Scene, class Vec>
void check(const Step& step, const Problem<Real, Scene, Vec>& problem, int in_position,
           int in_velocity) {
  int steps = problem.steps[std::size_t(std::max(in_position, in_velocity))];
  Errors coarse = largest_errors(step, problem, steps);
  double position_before = 0, velocity_before = 0;
  for (int halving = 0; halving < 3; ++halving) {
    steps *= 2;
    const Errors fine = largest_errors(step, problem, steps);
    const double position = std::log2(coarse.position / fine.position);
    const double velocity = std::log2(coarse.velocity / fine.velocity);
    CAPTURE(steps, position, velocity, std::log10(fine.position), std::log10(fine.velocity));
    CHECK(std::abs(position - in_position) < 0.1);
    CHECK(std::abs(velocity - in_velocity) < 0.1);
    if (halving > 0) {
      CHECK(std::abs(position - position_before) < 0.05);
      CHECK(std::abs(velocity - velocity_before) < 0.05);
    }
    CHECK(std::min(fine.position, fine.velocity) >
          1e3 * double(std::numeric_limits<Real>::epsilon()));
    position_before = position, velocity_before = velocity;
    coarse = fine;
  }
}

}  // namespace order
