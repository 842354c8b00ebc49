// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "judge/tests.h"

using namespace judge;

namespace {

// Place and velocity at once, and a row of the table for each stage.
void take_step(Vec& x, Vec& v, double t, double h, const Acceleration& force) {
  constexpr double rows[4][3] = {{}, {1.0 / 3, 0, 0}, {-1.0 / 3, 1, 0}, {1, -1, 1}};
  const State start{x, v};
  State slopes[4];
  for (int i = 0; i < 4; ++i) {
    State stage = start;
    for (int j = 0; j < i; ++j) {
      stage.x += rows[i][j] * h * slopes[j].x;
      stage.v += rows[i][j] * h * slopes[j].v;
    }
    slopes[i] = {stage.v, force(stage.x, stage.v, t + i / 3.0 * h)};
    const double weight = (i % 3 == 0 ? 1 : 3) / 8.0;
    x += weight * h * slopes[i].x;
    v += weight * h * slopes[i].v;
  }
}

const Method three_eighths = method("Kutta's three-eighths rule", take_step);

}  // namespace

TEST_CASE("five steps under a hidden force are Kutta's", "[3-runge-kutta/racing-car][3 points]") {
  Student student;
  is_method(student, three_eighths,
            "Write the four stages side by side: which slopes lead to each, and is it looked at "
            "where they lead?");
}

TEST_CASE("each of the four questions is asked where the rule asks it",
          "[3-runge-kutta/racing-car][2 points]") {
  Student student;
  evaluates(student, three_eighths, 4, 0,
            "No two of the four questions are the same: each has a time and a place of its own.");
}

TEST_CASE("half the step divides the error by sixteen", "[3-runge-kutta/racing-car][3 points]") {
  Student student;
  has_order(student, 4, 128,
            "Four looks buy four orders only if every one of them is used in its own place.");
}

TEST_CASE("an orbit loses only the energy that this rule takes",
          "[3-runge-kutta/racing-car][2 points]") {
  Student student;
  has_energy_of(
      student, three_eighths, 0.3, 10, 40,
      "The rule takes a little energy on every turn. Yours takes another amount, or gives.");
}
