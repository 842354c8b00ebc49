// SPDX-License-Identifier: MIT-0
// Terminal speeds that were measured in engines as they ship, against the formula of each. All fall
// with g = 10 m/s^2 in steps of 1/64 s.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "measure/methods.h"
#include "measure/run.h"
#include "scenes/linear_drag.h"

using Catch::Matchers::WithinAbs;

namespace {

// In single precision, as they have it: the last roundings stop the fall a little early.
template <class Step>
double terminal_speed(const Step& step, float c, float h) {
  const scenes::LinearDrag<float> fall{.c = c, .g = 10};
  return double(-measure::after(step, fall, fall.start(), h, std::lround(100 / (c * h))).v);
}

constexpr float h = 1.0f / 64;
constexpr double digits = 5e-6;  // five decimals were noted

}  // namespace

TEST_CASE("Box2D 3 with a damping of 2 falls at 5.15625 m/s, with four substeps at 5.03903") {
  const auto& step = measure::linear_damping_implicit_first;
  CHECK_THAT(terminal_speed(step, 2, h), WithinAbs(5.15625, digits));
  CHECK_THAT(terminal_speed(step, 2, h / 4), WithinAbs(5.03903, digits));
}

TEST_CASE("Box2D 2.4 with a damping of 2 falls at the true 5 m/s") {
  CHECK_THAT(terminal_speed(measure::linear_damping_implicit_last, 2, h), WithinAbs(5, digits));
}

TEST_CASE("Bullet with a damping of 1/2 falls at 14.50517 m/s") {
  // It keeps (1 - 1/2)^h of the speed.
  const float c = -std::log(1 - 0.5f);
  CHECK_THAT(terminal_speed(measure::linear_damping_exponential_first, c, h),
             WithinAbs(14.50517, digits));
}
