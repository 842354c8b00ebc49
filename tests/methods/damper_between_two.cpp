// SPDX-License-Identifier: MIT-0
// A damper between two bodies: what it divides is the speed at which they part, or it brakes both.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>

#include "integrate/linear_damping.h"

using Catch::Matchers::WithinAbs;

namespace {

// Two masses on a damped spring without length, thrown through empty space at 10 m/s.
struct Thrown {
  double m1 = 2, m2 = 3, stiffness = 40, damper = 2;
  double x1 = 0, v1 = 10, x2 = 1, v2 = 10;

  double momentum() const { return m1 * v1 + m2 * v2; }
  double energy() const {
    const double parting = v2 - v1, apart = x2 - x1;
    return stiffness * apart * apart + parting * parting / (1 / m1 + 1 / m2);
  }

  // As over linear_damping.h.
  void step(double h) {
    const double light = 1 / m1 + 1 / m2;
    const double pull = stiffness * (x2 - x1);
    v1 += h * pull / m1, v2 -= h * pull / m2;
    const double parting = v2 - v1;
    const double impulse = (parting - parting / (1 + damper * h * light)) / light;
    v1 += impulse / m1, v2 -= impulse / m2;
    x1 += h * v1, x2 += h * v2;
  }

  // The wrong way: each velocity divided, as if the damper were tied to the world.
  void step_against_the_world(double h) {
    const double pull = stiffness * (x2 - x1);
    const auto force = [](double a) { return [a](double, double, double) { return a; }; };
    integrate::linear_damping_implicit_last(x1, v1, 0.0, h, damper / m1, force(pull / m1));
    integrate::linear_damping_implicit_last(x2, v2, 0.0, h, damper / m2, force(-pull / m2));
  }
};

}  // namespace

TEST_CASE("Two masses on a damped spring fly on at 10 m/s if the speed of parting is divided") {
  for (const double h : {1 / 240.0, 1 / 60.0, 1 / 10.0}) {
    for (int power = -6; power <= 9; ++power) {
      Thrown pair{.damper = std::pow(10.0, power) / h};
      CAPTURE(h, pair.damper);
      const double start = pair.energy(), momentum = pair.momentum();
      const int steps = 1000;
      double most = 0;
      for (int n = 0; n < steps; ++n) {
        pair.step(h);
        most = std::max(most, pair.energy());
      }
      // Each step rounds some eight times by half an epsilon of the momentum.
      const double rounding = 4 * std::numeric_limits<double>::epsilon() * steps * momentum;
      CHECK_THAT(pair.momentum(), WithinAbs(momentum, rounding));
      CHECK(most < 3 * start);
    }
  }
}

TEST_CASE("Divided in the world instead, they brake to 0.08 m/s within a second") {
  Thrown right{.m1 = 1, .m2 = 1, .damper = 5}, wrong = right;
  for (int n = 0; n < 60; ++n) {
    right.step(1 / 60.0);
    wrong.step_against_the_world(1 / 60.0);
  }
  CHECK_THAT(right.momentum() / 2, WithinAbs(10, 1e-13));
  CHECK_THAT(wrong.momentum() / 2, WithinAbs(10 / std::pow(1 + 5 / 60.0, 60), 1e-13));
  CHECK_THAT(wrong.momentum() / 2, WithinAbs(0.08, 0.005));
}
