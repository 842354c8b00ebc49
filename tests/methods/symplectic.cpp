// SPDX-License-Identifier: MIT-0
// Whether a step keeps areas: the determinant of its Jacobian on a force that is not linear.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <typeinfo>

#include "measure/methods.h"
#include "measure/run.h"

using Catch::Matchers::WithinAbs;

namespace {

using Complex = std::complex<double>;

// A pendulum's sine, cut off: x'' = x^3 / 6 - x.
struct Swing {
  Complex operator()(const Complex& x, const Complex&, double) const { return x * x * x / 6.0 - x; }
  static Complex slope(const Complex& x) { return x * x / 2.0 - 1.0; }
};

const auto solve = [](const Complex& x, const Complex&, double, double p, double, Complex& change) {
  change = change / (1.0 + p * Swing::slope(x));
  return true;
};
const auto size = [](const Complex& y) { return std::abs(y); };

// One step from what the method keeps: the first two, and an acceleration that belongs to them.
template <class Method>
std::array<Complex, 2> moved(Method, Complex first, Complex second, double h) {
  auto memory = measure::start(Method(), scenes::State<Complex>{first, second}, h, Swing());
  memory[0] = first, memory[1] = second;
  measure::advance(Method(), memory, 0.0, h, Swing());
  return {memory[0], memory[1]};
}
std::array<Complex, 2> moved(measure::BackwardEuler, Complex x, Complex v, double h) {
  REQUIRE(integrate::backward_euler(x, v, 0.0, h, Swing(), solve));
  return {x, v};
}
std::array<Complex, 2> moved(measure::BackwardEulerNewton, Complex x, Complex v, double h) {
  REQUIRE(integrate::backward_euler_newton(x, v, 0.0, h, Swing(), solve, size, 1e-14) > 0);
  return {x, v};
}
std::array<Complex, 2> moved(measure::Trapezoid, Complex x, Complex v, double h) {
  REQUIRE(integrate::trapezoid(x, v, 0.0, h, Swing(), solve));
  return {x, v};
}
std::array<Complex, 2> moved(measure::TrapezoidNewton, Complex x, Complex v, double h) {
  REQUIRE(integrate::trapezoid_newton(x, v, 0.0, h, Swing(), solve, size, 1e-14) > 0);
  return {x, v};
}
std::array<Complex, 2> moved(measure::Bdf2, Complex x, Complex v, double h) {
  auto previous = integrate::bdf2_start(x, v, 0.0, h, Swing());
  REQUIRE(integrate::bdf2(x, v, previous, 0.0, h, h, Swing(), solve));
  return {x, v};
}
std::array<Complex, 2> moved(measure::Bdf2Newton, Complex x, Complex v, double h) {
  auto previous = integrate::bdf2_start(x, v, 0.0, h, Swing());
  REQUIRE(integrate::bdf2_newton(x, v, previous, 0.0, h, h, Swing(), solve, size, 1e-14) > 0);
  return {x, v};
}

struct Determinant {
  double value, rounding;  // some ten operations for each entry
};

// A step into the complex plane, too small to change the real part, gives the derivative without
// the difference of two numbers.
template <class Method>
Determinant determinant(double first, double second, double h) {
  constexpr double tiny = 1e-30;
  const auto by_first = moved(Method(), Complex(first, tiny), second, h);
  const auto by_second = moved(Method(), first, Complex(second, tiny), h);
  const double diagonal = by_first[0].imag() / tiny * (by_second[1].imag() / tiny);
  const double other = by_first[1].imag() / tiny * (by_second[0].imag() / tiny);
  const double rounding = 20 * std::numeric_limits<double>::epsilon();
  return {diagonal - other, rounding * (std::abs(diagonal) + std::abs(other))};
}

using Symplectic = list::Where<[](auto method) { return method.symplectic; }>;
using NotSymplectic = list::Where<[](auto method) { return !method.symplectic; }>;

}  // namespace

TEMPLATE_LIST_TEST_CASE("The step keeps areas: its Jacobian has determinant 1", "", Symplectic) {
  INFO(typeid(TestType).name());
  for (const double h : {0.1, 0.5, 1.5}) {
    for (const double first : {0.2, 1.3, -2.5}) {
      CAPTURE(h, first);
      const auto [value, rounding] = determinant<TestType>(first, 0.8, h);
      CHECK_THAT(value, WithinAbs(1, rounding));
    }
  }
}

TEMPLATE_LIST_TEST_CASE("The step does not keep areas", "", NotSymplectic) {
  INFO(typeid(TestType).name());
  for (const double h : {0.5, 1.0, 1.5}) {
    const auto [value, rounding] = determinant<TestType>(1.3, 0.8, h);
    CAPTURE(h, value);
    CHECK(std::abs(value - 1) > 1e5 * rounding);
  }
}

TEST_CASE(
    "Euler swells areas by 1 - h^2 da/dx, implicit Euler shrinks them by as much at the end") {
  for (const double h : {0.1, 0.5}) {
    const double x = 1.3, v = 0.8;
    const double slope = Swing::slope(x).real();
    const auto euler = determinant<measure::Euler>(x, v, h);
    CHECK_THAT(euler.value, WithinAbs(1 - h * h * slope, euler.rounding));
    const double x_end = moved(measure::BackwardEulerNewton(), x, v, h)[0].real();
    const double slope_end = Swing::slope(x_end).real();
    const auto implicit = determinant<measure::BackwardEulerNewton>(x, v, h);
    CHECK_THAT(implicit.value, WithinAbs(1 / (1 - h * h * slope_end), implicit.rounding));
  }
}
