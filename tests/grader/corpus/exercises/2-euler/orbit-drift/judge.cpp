// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "judge/tests.h"

using namespace judge;

TEST_CASE("five steps under a hidden force are Euler's", "[2-euler/orbit-drift][4 points]") {
  Student student;
  is_method(student, euler, "Both lines of the formula use the state at the start of the step.");
}

TEST_CASE("the acceleration is asked for once a step, at its start",
          "[2-euler/orbit-drift][2 points]") {
  Student student;
  evaluates(student, euler, 1, 0, "Ask once, at (x, v, t), before you change any of them.");
}

TEST_CASE("an orbit gains the energy that Euler's method gives it",
          "[2-euler/orbit-drift][3 points]") {
  Student student;
  has_energy_of(student, euler, 0.2, 5, 400,
                "Under Euler's method the orbit widens, turn after turn. Does each line use the "
                "old x and v?");
}

TEST_CASE("half the step halves the error", "[2-euler/orbit-drift][1 point]") {
  Student student;
  has_order(student, 1, 512,
            "The method has order one. Is something wrong by the same amount "
            "however small the step is?");
}
