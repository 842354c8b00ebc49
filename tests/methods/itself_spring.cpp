// SPDX-License-Identifier: MIT-0
// The methods that know their force: implicit Euler by formula, and RK4 folded into a matrix.
#include <Eigen/LU>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>

#include "integrate/backward_euler_spring.h"
#include "integrate/rk4_linear.h"
#include "textbook/exponential.h"
#include "textbook/runge_kutta.h"

using Catch::Matchers::WithinAbs;

namespace {

using textbook::Matrix;
using textbook::Pair;
using textbook::Real;

// Half the distance between 1 and the next number: what a rounding adds or takes, at most.
template <class Vec>
const double rounding = double(std::numeric_limits<Vec>::epsilon()) / 2;

// z' = A z for the pair z of position and velocity, with k = omega^2 and c = 2 zeta omega.
Matrix equation(Real k, Real c) {
  Matrix a;
  a << 0, 1, -k, -c;
  return a;
}

template <class Vec, class Check>
void for_springs_and_steps(Check check) {
  for (const Vec omega : {Vec(0), Vec(0.7), Vec(2.5)}) {
    for (const Vec zeta : {Vec(0), Vec(0.3), Vec(1), Vec(3)}) {
      for (const Vec h : {Vec(0.3), Vec(-0.2), Vec(8)}) {
        CAPTURE(omega, zeta, h);
        check(omega, zeta, h);
      }
    }
  }
}

}  // namespace

TEMPLATE_TEST_CASE("Implicit Euler on a spring solves (1 - h A) z' = z", "", double, float) {
  for_springs_and_steps<TestType>([](TestType omega, TestType zeta, TestType h) {
    TestType x = TestType(0.7), v = TestType(-1.1);
    const Real angle = Real(h) * omega;
    const Matrix a = equation(Real(omega) * omega, 2 * Real(zeta) * omega);
    const Matrix system = Matrix::Identity() - h * a;
    const Pair expected = system.partialPivLu().solve(Pair(x, v));
    integrate::backward_euler_spring(x, v, h, omega, zeta);
    // About ten roundings, each of them as large as the terms of the sums are without their signs.
    const Real divisor = std::abs(system.determinant());
    const Real terms = (1 + 2 * zeta * std::abs(angle) + angle * angle) / divisor;
    const Real speeds = (Real(1.1) + std::abs(angle) * omega * Real(0.7)) / divisor * terms;
    const Real places = Real(0.7) + std::abs(h) * speeds;
    CHECK_THAT(v, WithinAbs(double(expected[1]), 10 * rounding<TestType> * double(speeds)));
    CHECK_THAT(x, WithinAbs(double(expected[0]), 12 * rounding<TestType> * double(places)));
  });
}

TEMPLATE_TEST_CASE("RK4 in a matrix takes the steps of RK4's table", "", double, float) {
  for_springs_and_steps<TestType>([](TestType omega, TestType zeta, TestType h) {
    const TestType k = omega * omega, c = 2 * zeta * omega;
    const auto force = [=](Real x, Real v, Real) { return -k * x - c * v; };
    TestType x = TestType(0.7), v = TestType(-1.1);
    const auto expected = textbook::steps(measure::Rk4(), force, {x, v}, h, 1).front();
    integrate::rk4_linear(x, v, integrate::rk4_linear_start(k, c, h));
    // The polynomial of four levels rounds six times in each, on terms without their signs.
    const Matrix terms = textbook::exponential((h * equation(k, c)).cwiseAbs());
    const Pair sizes = 24 * rounding<TestType> * terms * Pair(Real(0.7), Real(1.1));
    CHECK_THAT(x, WithinAbs(double(expected.x), double(sizes[0])));
    CHECK_THAT(v, WithinAbs(double(expected.v), double(sizes[1])));
  });
}
