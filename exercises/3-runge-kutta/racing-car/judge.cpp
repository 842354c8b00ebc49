// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "../table.h"
#include "judge/tests.h"

using namespace judge;

namespace {

const Method three_eighths = method_of({"Kutta's three-eighths rule",
                                        {{}, {1.0 / 3}, {-1.0 / 3, 1}, {1, -1, 1}},
                                        {1.0 / 8, 3.0 / 8, 3.0 / 8, 1.0 / 8}});

}  // namespace

TEST_CASE("five steps under a hidden force are Kutta's", "[3-runge-kutta/racing-car][2 points]") {
  Student student;
  is_method(student, three_eighths,
            "Write the four stages side by side: which slopes lead to each, and is it looked at "
            "where they lead?");
}

TEST_CASE("a step of any car is Kutta's, from anywhere, however long it is",
          "[3-runge-kutta/racing-car][1 point]") {
  Student student;
  is_method_everywhere(student, three_eighths,
                       "Which step is so short, or which car so slow or so fast, that a line of "
                       "yours does something of its own?");
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
