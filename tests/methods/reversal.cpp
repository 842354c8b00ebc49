// SPDX-License-Identifier: MIT-0
// There and back again: who finds the start to rounding, and by how much the others miss it.
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>
#include <typeinfo>
#include <utility>

#include "measure/methods.h"
#include "measure/run.h"
#include "theory.h"

namespace {

// Not linear, pushed in time, and without drag.
struct Swing {
  double operator()(double x, double, double t) const { return t / 10 - x * x * x; }
  template <class Add>
  void jacobian(double x, double, double, Add&& add) const {
    add(0, 0, -3 * x * x, 0.0);
  }
};
constexpr Swing swing;
constexpr double duration = 3;

// Turns what a method keeps at time t after steps of h, so that steps of -h lead back. Returns the
// time of its position: position Verlet's two change places.
double turn(auto, auto&, double t, double) {
  return t;
}
double turn(theory::OneOf<measure::StormerVerlet, measure::StormerVerletUneven,
                          measure::StormerVerletCarried> auto,
            auto& memory, double t, double h) {
  std::swap(memory[0], memory[1]);
  return t - h;
}
double turn(measure::StormerVerletDistance, auto& memory, double t, double h) {
  memory[0] -= memory[1];
  memory[1] = -memory[1];
  return t - h;
}
double turn(measure::Leapfrog, auto& memory, double t, double h) {
  const double v = integrate::leapfrog_velocity(memory[0], memory[1], t, h, swing);
  memory[1] = integrate::leapfrog_start(memory[0], v, t, -h, swing);
  return t;
}

// How far from the start a method comes back, in what it keeps of position and velocity.
template <class Method>
double miss(int steps) {
  const double h = duration / steps;
  const auto first = measure::start(Method(), scenes::State<double>{1.1, 0.4}, h, swing);
  auto memory = first;
  for (int n = 0; n < steps; ++n) measure::advance(Method(), memory, n * h, h, swing);
  const double end = turn(Method(), memory, duration, h);
  for (int n = 0; n < steps; ++n) measure::advance(Method(), memory, end - n * h, -h, swing);
  turn(Method(), memory, 0, -h);
  return std::max(std::abs(memory[0] - first[0]), std::abs(memory[1] - first[1]));
}

// A position rounded in one step moves all later ones by as much a step, as if it were thrown.
constexpr double rounding(int steps) {
  return steps * steps * std::numeric_limits<double>::epsilon();
}

using Symmetric = list::Where<[](auto method) { return method.reversible; }>;
using NotSymmetric =
    list::Where<[](auto method) { return !method.reversible && method.allows_negative_step; }>;

// Errors of even powers of h cancel on the way back: what is missed is of the next odd order.
constexpr int power_of_miss(auto method) {
  return method.order + (method.order + 1) % 2;
}
// One iteration of Newton's is off the symmetric rule by h^5 in a step.
constexpr int power_of_miss(measure::Trapezoid) {
  return 5;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("Forward and back again it finds the start to rounding", "", Symmetric) {
  INFO(typeid(TestType).name());
  CHECK(miss<TestType>(100) < rounding(100));
}

TEMPLATE_LIST_TEST_CASE("Forward and back again it misses the start, as its order says", "",
                        NotSymmetric) {
  INFO(typeid(TestType).name());
  constexpr int power = power_of_miss(TestType());
  constexpr int steps = power == 1 ? 1600 : 50;
  const double coarse = miss<TestType>(steps), fine = miss<TestType>(2 * steps);
  CHECK(fine > 100 * rounding(2 * steps));
  CHECK(std::abs(std::log2(coarse / fine) - power) < 0.1);
}

TEST_CASE("Each twin of symplectic Euler takes back the other's steps") {
  const double h = 0.03;
  double x = 1.1, v = 0.4;
  SECTION("velocity first, then position first") {
    for (int n = 0; n < 100; ++n) integrate::symplectic_euler(x, v, n * h, h, swing);
    for (int n = 100; n > 0; --n) {
      integrate::symplectic_euler_position_first(x, v, n * h, -h, swing);
    }
  }
  SECTION("position first, then velocity first") {
    for (int n = 0; n < 100; ++n) {
      integrate::symplectic_euler_position_first(x, v, n * h, h, swing);
    }
    for (int n = 100; n > 0; --n) integrate::symplectic_euler(x, v, n * h, -h, swing);
  }
  CHECK(std::abs(x - 1.1) < rounding(100));
  CHECK(std::abs(v - 0.4) < rounding(100));
}

TEST_CASE("Euler with a negative step takes back a step of implicit Euler") {
  const double h = 0.3;
  double x = 1.1, v = 0.4;
  measure::backward_euler_newton(x, v, 0.0, h, swing);
  integrate::euler(x, v, h, -h, swing);
  // As far as Newton's method was told to go.
  CHECK(std::abs(x - 1.1) < 1e-13);
  CHECK(std::abs(v - 0.4) < 1e-13);
}
