// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "judge/tests.h"

using namespace judge;

TEST_CASE("five steps under a hidden force are RK4's", "[3-runge-kutta/racing-car][3 points]") {
  Student student;
  is_method(student, rk4,
            "Write the four stages side by side: which slope leads to each, and is it looked at "
            "where it leads?");
}

TEST_CASE("each of the four questions is asked where RK4 asks it",
          "[3-runge-kutta/racing-car][2 points]") {
  Student student;
  evaluates(student, rk4, 4, 0,
            "No two of the four questions are the same: the second and the third are asked at one "
            "time, in two places.");
}

TEST_CASE("half the step divides the error by sixteen", "[3-runge-kutta/racing-car][3 points]") {
  Student student;
  has_order(student, 4, 128,
            "Four looks buy four orders only if every one of them is used in its own place.");
}

TEST_CASE("an orbit loses only the energy that RK4 takes", "[3-runge-kutta/racing-car][2 points]") {
  Student student;
  has_energy_of(student, rk4, 0.3, 10, 40,
                "RK4 takes a little energy on every turn. Yours takes another amount, or gives.");
}
