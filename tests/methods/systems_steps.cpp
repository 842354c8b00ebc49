// SPDX-License-Identifier: MIT-0
// What the implicit methods do when a linear system cannot be solved, or solving does not help.
#include "systems_steps.h"

#include <Eigen/Core>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <limits>
#include <vector>

#include "integrate/dense_system.h"
#include "systems_try.h"

using namespace systems;

TEMPLATE_TEST_CASE("A step whose system cannot be solved leaves position and velocity alone", "",
                   Once, Newton, TrapezoidOnce, TrapezoidNewton, Bdf2Once, Bdf2Newton) {
  // Also if the system has spoilt what it was to change.
  const auto refuse = [](double, double, double, double, double, double& change) {
    change = std::numeric_limits<double>::quiet_NaN();
    return false;
  };
  double x = 1.5, v = -0.25;
  CHECK(TestType::step(x, v, 0.1, cubic, refuse, 1e-9) == 0);
  CHECK(x == 1.5);
  CHECK(v == -0.25);
}

TEMPLATE_TEST_CASE("Newton's method that fails in a later iteration leaves them alone, too", "",
                   Newton, TrapezoidNewton, Bdf2Newton) {
  int left = 3;
  const auto refuse_later = [&left](double x, double v, double t, double p, double q,
                                    double& change) {
    return left-- > 0 && solve_cubic(x, v, t, p, q, change);
  };
  double x = 1.5, v = -0.25;
  CHECK(TestType::step(x, v, 0.5, cubic, refuse_later, unreachable) == 0);
  CHECK(left == -1);
  CHECK(x == 1.5);
  CHECK(v == -0.25);
}

TEMPLATE_TEST_CASE("Newton's method that finds no end gives up after fifty iterations", "", Newton,
                   TrapezoidNewton, Bdf2Newton) {
  int solves = 0;
  const auto count = [&solves](double x, double v, double t, double p, double q, double& change) {
    ++solves;
    return solve_cubic(x, v, t, p, q, change);
  };
  double x = 1.5, v = -0.25;
  CHECK(TestType::step(x, v, 0.5, cubic, count, unreachable) == 0);
  CHECK(solves == 50);
  CHECK(x == 1.5);
  CHECK(v == -0.25);
}

TEMPLATE_TEST_CASE("Newton's method with derivatives of the wrong sign says that it found no end",
                   "", Newton, TrapezoidNewton, Bdf2Newton) {
  const auto wrong = [](double x, double v, double t, double p, double q, double& change) {
    return solve_cubic(x, v, t, -p, q, change);
  };
  double x = 1.5, v = -0.25;
  CHECK(TestType::step(x, v, 0.8, cubic, wrong, 1e-9) == 0);
  CHECK(x == 1.5);
  CHECK(v == -0.25);
}

TEMPLATE_TEST_CASE("An acceleration that is not a number is no step", "", Once, Newton,
                   TrapezoidOnce, TrapezoidNewton, Bdf2Once, Bdf2Newton) {
  const auto broken = [](const Eigen::Vector2d& x, const Eigen::Vector2d&, double) {
    return Eigen::Vector2d(std::numeric_limits<double>::quiet_NaN() * x);
  };
  const std::vector<Entry> entries{{0, 0, -3}, {1, 1, -2}};
  integrate::DenseSystem<Entries, double, 2> solve(Entries{&entries});
  Eigen::Vector2d x(1, 2), v(3, 4);
  CHECK(TestType::step(x, v, 0.05, broken, solve, 1e-9) == 0);
  CHECK(x == Eigen::Vector2d(1, 2));
  CHECK(v == Eigen::Vector2d(3, 4));
}

TEMPLATE_TEST_CASE("Newton's method finds no end where the acceleration is not a number", "",
                   Newton, TrapezoidNewton, Bdf2Newton) {
  // With a system that takes no notice of it.
  const auto broken = [](double, double, double) {
    return std::numeric_limits<double>::quiet_NaN();
  };
  double x = 1.5, v = -0.25;
  CHECK(TestType::step(x, v, 0.1, broken, solve_cubic, 1e-9) == 0);
  CHECK(x == 1.5);
  CHECK(v == -0.25);
}
