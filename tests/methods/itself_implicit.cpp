// SPDX-License-Identifier: MIT-0
// The implicit methods: what they find is put back into the implicit formula, and what they do
// where nothing can be found.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>

#include "integrate/backward_euler.h"
#include "integrate/bdf2.h"
#include "integrate/trapezoid.h"
#include "textbook/runge_kutta.h"

using Catch::Matchers::WithinAbs;

namespace {

const textbook::Pushed pushed;

// Solves for a single unknown, as the headers tell their reader to.
constexpr auto solve = [](const auto& x, const auto& v, auto t, auto p, auto q, auto& change) {
  pushed.jacobian(x, v, t, [&](int, int, auto dadx, auto dadv) {
    change = change / (1 + p * dadx + q * dadv);
  });
  return true;
};
constexpr auto unsolvable = [](auto&&...) { return false; };
constexpr auto endless = [](auto&&, auto&&, auto, auto, auto, auto& change) {
  change = 1;
  return true;
};
constexpr auto size = [](const auto& y) { return std::abs(y); };

// Fewer than 64 roundings of numbers below 4 in an iteration, and each of them by half an epsilon.
// The last iteration starts closer than the root of that, and what it leaves is the square.
template <class Real>
const Real rounding = 128 * std::numeric_limits<Real>::epsilon();

using textbook::Pair;

}  // namespace

TEMPLATE_TEST_CASE("What Newton's method finds for implicit Euler solves z' = z + h f(t + h, z')",
                   "", double, float) {
  TestType x = TestType(0.7), v = TestType(-1.1);
  for (int n = 0; n < 8; ++n) {
    const TestType h = TestType(0.3), t = TestType(n) * h;
    const Pair before{x, v};
    REQUIRE(integrate::backward_euler_newton(x, v, t, h, pushed, solve, size, rounding<TestType>));
    const Pair after{x, v};
    const Pair defect = after - before - h * textbook::slope(pushed, after, t + h);
    CHECK_THAT(double(defect.norm()), WithinAbs(0, rounding<TestType>));
  }
}

TEMPLATE_TEST_CASE("What Newton's method finds for the trapezoid rule has the mean of both slopes",
                   "", double, float) {
  for (const TestType h : {TestType(0.3), TestType(-0.2)}) {
    TestType x = TestType(0.7), v = TestType(-1.1);
    for (int n = 0; n < 8; ++n) {
      const TestType t = TestType(n) * h;
      const Pair before{x, v};
      REQUIRE(integrate::trapezoid_newton(x, v, t, h, pushed, solve, size, rounding<TestType>));
      const Pair after{x, v};
      const Pair slopes =
          textbook::slope(pushed, before, t) + textbook::slope(pushed, after, t + h);
      const Pair defect = after - before - h / 2 * slopes;
      CHECK_THAT(double(defect.norm()), WithinAbs(0, rounding<TestType>));
    }
  }
}

// By divided differences: the slope of the last step, and its length times the second difference.
TEMPLATE_TEST_CASE("Through what BDF2 finds and the last two states a parabola has the end's slope",
                   "", double, float) {
  TestType x = TestType(0.7), v = TestType(-1.1), t = TestType(0.2), h_previous = TestType(0.1);
  integrate::Bdf2Previous<TestType> previous{TestType(0.8), TestType(-0.9)};
  for (const double length : {0.3, 0.3, 0.1, 0.05, 0.25, 0.4, 0.4}) {
    const TestType h = TestType(length);
    const Pair two_ago{previous.x, previous.v}, one_ago{x, v};
    REQUIRE(integrate::bdf2_newton(x, v, previous, t, h, h_previous, pushed, solve, size,
                                   rounding<TestType>));
    CHECK(previous.x == TestType(one_ago[0]));
    CHECK(previous.v == TestType(one_ago[1]));
    const Pair after{x, v};
    const Pair last = (after - one_ago) / h, before = (one_ago - two_ago) / h_previous;
    const Pair second = (last - before) / (textbook::Real(h) + h_previous);
    const Pair defect = last + h * second - textbook::slope(pushed, after, t + h);
    // Each state is rounded, and the differences divide by steps.
    CHECK_THAT(double(defect.norm()), WithinAbs(0, 2 * rounding<TestType> / h));
    t += h;
    h_previous = h;
  }
}

TEMPLATE_TEST_CASE("BDF2 starts with a state from which backward Euler would come", "", double,
                   float) {
  TestType x = TestType(0.7), v = TestType(-1.1);
  const TestType t = TestType(2.3), h = TestType(0.3);
  const auto previous = integrate::bdf2_start(x, v, t, h, pushed);
  const Pair here{x, v};
  const Pair before{previous.x, previous.v};
  const Pair defect = here - before - h * textbook::slope(pushed, here, t);
  CHECK_THAT(double(defect.norm()), WithinAbs(0, rounding<TestType>));
}

TEST_CASE("Newton's method stops where its tolerance is met, and counts its iterations") {
  long evaluations = 0;
  const auto counted = [&evaluations](double x, double v, double t) {
    ++evaluations;
    return pushed(x, v, t);
  };
  const auto iterations = [&](double tolerance, bool trapezoid) {
    double x = 0.7, v = -1.1;
    evaluations = 0;
    return trapezoid
               ? integrate::trapezoid_newton(x, v, 0.0, 0.3, counted, solve, size, tolerance)
               : integrate::backward_euler_newton(x, v, 0.0, 0.3, counted, solve, size, tolerance);
  };
  for (const bool trapezoid : {false, true}) {
    CAPTURE(trapezoid);
    CHECK(iterations(10, trapezoid) == 1);
    CHECK(evaluations == 1 + trapezoid);
    const int rough = iterations(1e-4, trapezoid);
    const int fine = iterations(1e-13, trapezoid);
    CHECK(evaluations == fine + trapezoid);
    CHECK(rough < fine);
    CHECK(fine <= 2 * rough);  // the number of right digits doubles with each iteration
  }
}

TEST_CASE("An implicit step that cannot be solved says so and leaves everything as it was") {
  double x = 0.7, v = -1.1;
  SECTION("one solve of implicit Euler") {
    CHECK_FALSE(integrate::backward_euler(x, v, 0.0, 0.3, pushed, unsolvable));
  }
  SECTION("one solve of the trapezoid rule") {
    CHECK_FALSE(integrate::trapezoid(x, v, 0.0, 0.3, pushed, unsolvable));
  }
  SECTION("Newton's method for implicit Euler") {
    CHECK(integrate::backward_euler_newton(x, v, 0.0, 0.3, pushed, unsolvable, size, 1e-9) == 0);
    CHECK(integrate::backward_euler_newton(x, v, 0.0, 0.3, pushed, endless, size, 1e-9) == 0);
  }
  SECTION("Newton's method for the trapezoid rule") {
    CHECK(integrate::trapezoid_newton(x, v, 0.0, 0.3, pushed, unsolvable, size, 1e-9) == 0);
    CHECK(integrate::trapezoid_newton(x, v, 0.0, 0.3, pushed, endless, size, 1e-9) == 0);
  }
  SECTION("BDF2, once and by Newton's method") {
    integrate::Bdf2Previous<double> previous{0.8, -0.9};
    CHECK_FALSE(integrate::bdf2(x, v, previous, 0.0, 0.3, 0.1, pushed, unsolvable));
    CHECK(integrate::bdf2_newton(x, v, previous, 0.0, 0.3, 0.1, pushed, unsolvable, size, 1e-9) ==
          0);
    CHECK(integrate::bdf2_newton(x, v, previous, 0.0, 0.3, 0.1, pushed, endless, size, 1e-9) == 0);
    CHECK(previous.x == 0.8);
    CHECK(previous.v == -0.9);
  }
  CHECK(x == 0.7);
  CHECK(v == -1.1);
}
