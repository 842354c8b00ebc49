// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "judge/tests.h"

using namespace judge;

TEST_CASE("five steps under a hidden force are the midpoint method's",
          "[3-runge-kutta/midpoint-line][4 points]") {
  Student student;
  is_method(student, midpoint, "The position moves for the whole step with one velocity. Which?");
}

TEST_CASE("the acceleration is asked for twice a step, at the start and in the middle",
          "[3-runge-kutta/midpoint-line][2 points]") {
  Student student;
  is_method(student, midpoint, "Both halves of the step begin where the step does.");
  evaluates(
      student, midpoint, 2, 0,
      "The starter asks twice already, and your line needs no third. If a place is wrong, look "
      "at what the line did to x in the step before.");
}

TEST_CASE("half the step divides the error by four", "[3-runge-kutta/midpoint-line][2 points]") {
  Student student;
  has_order(student, 2, 512,
            "One word can cost an order: position and velocity must both see the middle.");
}

TEST_CASE("a drone on a circle gains only the energy that the midpoint method gives it",
          "[3-runge-kutta/midpoint-line][2 points]") {
  Student student;
  has_energy_of(student, midpoint, 0, 10, 60,
                "A step along the velocity of the start ends outside the circle. Where does one "
                "along the velocity of the middle end?");
}
