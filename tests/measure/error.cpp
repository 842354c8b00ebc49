// SPDX-License-Identifier: MIT-0
#include "measure/error.h"

#include <Eigen/Core>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <numbers>

#include "made_up.h"
#include "measure/methods/euler.h"
#include "scenes/projectile.h"

using Catch::Matchers::WithinRel;

TEST_CASE("The length of a number is its size, of a vector its norm") {
  CHECK(measure::length(-3.0) == 3);
  CHECK(measure::length(Eigen::Vector2d(3, -4)) == 5);
  const Eigen::Vector2d a{5, 1}, b{2, 5};
  CHECK(measure::length(a - b) == 5);
}

TEST_CASE("The largest error is found where it is, not at the end") {
  // The truth swings away from a method that does not move, and comes back.
  struct Hump : made_up::Drifter {
    scenes::State<double> start() const { return {0, 2}; }
    scenes::State<double> exact(double t) const {
      return {-3 * t * (4 - t), 2 + (t == 3 ? 7.0 : 0.0)};
    }
  };
  const auto rest = [](double&, double&, double, double, const auto&) {};
  const measure::Error error = measure::largest_error(rest, Hump(), 1.0, 4);
  CHECK(error.position == 12);
  CHECK(error.velocity == 7);
}

TEST_CASE("The error of Euler under constant force is a h t / 2, and none in the velocity") {
  const scenes::Projectile<> ball;
  const measure::Error error = measure::largest_error(measure::euler, ball, 0.125, 16);
  CHECK_THAT(error.position, WithinRel(9.81 * 0.125 * 2 / 2, 1e-13));
  CHECK(error.velocity < 1e-13);
}

TEST_CASE("A run that is not a number has no small error") {
  const auto broken = [](double& x, double&, double, double, const auto&) { x = NAN; };
  CHECK(std::isnan(measure::largest_error(broken, made_up::Drifter(), 1.0, 4).position));
}
