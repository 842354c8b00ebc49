// SPDX-License-Identifier: MIT-0
// How large a step may be where symplectic Euler damps by itself, in each of the ways that engines
// have.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <typeinfo>

#include "measure/methods.h"
#include "measure/stability.h"
#include "scenes/linear_drag.h"
#include "scenes/spring.h"
#include "theory_of_damping.h"

using scenes::LinearDrag;
using scenes::Spring;

namespace {

constexpr double zetas[] = {0.1, 0.5, 1, 2};

// The step matrix on a spring of omega = 2 is stable up to `limit`, and no further.
template <class Step>
void check_limit(const Step& step, double zeta, double limit) {
  CAPTURE(zeta, limit);
  const Spring<> spring{.omega = 2, .zeta = zeta};
  for (const double part : {0.01, 0.5, 0.9, 1 - 1e-9}) {
    CHECK(measure::is_stable(step, spring, part * limit / 2));
  }
  for (const double part : {1 + 1e-9, 1.01}) {
    CHECK_FALSE(measure::is_stable(step, spring, part * limit / 2));
  }
}

template <class Step>
void check_no_limit(const Step& step, double zeta) {
  CAPTURE(zeta);
  const Spring<> spring{.omega = 2, .zeta = zeta};
  for (double angle = 0.01; angle < 1000; angle *= 1.1) {
    CHECK(measure::is_stable(step, spring, angle / 2));
  }
}

// Where a rising function passes zero.
template <class Function>
double root(Function f, double low, double high) {
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (low + high) / 2;
    (f(middle) > 0 ? high : low) = middle;
  }
  return low;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("Damping within the step has no limit on drag", "", list::Damping) {
  INFO(typeid(TestType).name());
  for (const double ch : {0.01, 0.9, 1.0, 1.1, 5.0, 300.0}) {
    const LinearDrag<> drag{.c = 3, .g = 0, .v0 = 3};
    CHECK(measure::is_stable(TestType(), drag, ch / 3));
    CHECK(std::abs(measure::after(TestType(), drag, drag.start(), ch / 3, 10'000).v) < 1e-12);
  }
}

TEMPLATE_LIST_TEST_CASE("Without damping each of its forms is symplectic Euler", "",
                        list::Damping) {
  INFO(typeid(TestType).name());
  const Spring<> spring{.omega = 7};
  const auto symplectic = measure::step_matrix(measure::symplectic_euler, spring, 0.1);
  CHECK(measure::step_matrix(TestType(), spring, 0.1) == symplectic);
  check_limit(TestType(), 0, 2);
}

// The polynomial has a root of -1 where push s = 2 (1 + keep).

TEST_CASE("Divided after the force, damping lifts the limit to 2 (sqrt(1 + zeta^2) + zeta)") {
  for (const double zeta : zetas) {
    check_limit(measure::linear_damping_implicit_last, zeta,
                2 * (std::sqrt(1 + zeta * zeta) + zeta));
  }
}

TEST_CASE("Divided before the force, it lowers the limit: (h omega)^2 < 2 (2 + c h) / (1 + c h)") {
  for (const double zeta : zetas) {
    const double limit = root(
        [zeta](double angle) {
          const double ch = 2 * zeta * angle;
          return angle * angle - 2 * (2 + ch) / (1 + ch);
        },
        0, 3);
    CHECK(limit < 2);
    CHECK(limit > std::sqrt(2));
    check_limit(measure::linear_damping_implicit_first, zeta, limit);
  }
}

TEST_CASE(
    "Times 1 - c h before the force, it lowers the limit as explicit drag, down to root two") {
  for (const double zeta : zetas) {
    // Once c h is above one, no speed is kept and only (h omega)^2 < 2 counts.
    const double explicit_drag = 2 * (std::sqrt(1 + zeta * zeta) - zeta);
    const bool keeps = 2 * zeta * explicit_drag < 1;
    check_limit(measure::linear_damping_explicit_first, zeta,
                keeps ? explicit_drag : std::sqrt(2.0));
  }
}

TEST_CASE("Times 1 - c h after the force, it has no limit from zeta = 1/2: the body freezes") {
  const double limit =
      root([](double angle) { return angle * angle - 2 * (2 - 0.2 * angle) / (1 - 0.2 * angle); },
           0, 4.9);
  check_limit(measure::linear_damping_explicit_last, 0.1, limit);
  for (const double zeta : {0.5, 1.0, 2.0}) {
    check_no_limit(measure::linear_damping_explicit_last, zeta);
    const Spring<> frozen{.omega = 2, .zeta = zeta, .x0 = 3, .v0 = -1};
    const double h = 1.01 / frozen.damping();
    const auto end =
        measure::after(measure::linear_damping_explicit_last, frozen, frozen.start(), h, 1);
    CHECK(end.x == 3);
    CHECK(end.v == 0);
  }
}

TEST_CASE("Times exp(-c h) after the force, it has no limit from zeta = 1/2") {
  const double limit =
      root([](double angle) { return angle * angle - 2 * (std::exp(0.2 * angle) + 1); }, 0, 4);
  check_limit(measure::linear_damping_exponential_last, 0.1, limit);
  for (const double zeta : {0.5, 1.0, 2.0}) {
    check_no_limit(measure::linear_damping_exponential_last, zeta);
  }
}

TEST_CASE("Times exp(-c h) before the force, it lowers the limit: (h omega)^2 < 2 (1 + e^(-c h))") {
  for (const double zeta : zetas) {
    const double limit =
        root([zeta](double angle) { return angle * angle - 2 * (1 + std::exp(-2 * zeta * angle)); },
             0, 3);
    check_limit(measure::linear_damping_exponential_first, zeta, limit);
  }
}

TEST_CASE("With the exact velocity the limit is h omega tanh(zeta h omega) < 4 zeta") {
  for (const double zeta : zetas) {
    const double limit =
        root([zeta](double angle) { return angle * std::tanh(zeta * angle) - 4 * zeta; }, 0, 100);
    check_limit(measure::linear_damping_exact, zeta, limit);
  }
}
