// SPDX-License-Identifier: MIT-0
// Just inside its limit a run stays bounded; just outside it blows up.
#include "measure/stability.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "integrate/euler.h"
#include "integrate/symplectic_euler.h"
#include "measure/run.h"
#include "scenes/linear_drag.h"
#include "scenes/spring.h"

using Catch::Matchers::WithinRel;
using scenes::LinearDrag;
using scenes::Spring;
using scenes::State;

namespace {

// The energy after many steps, in terms of the energy at the start.
template <class Step>
double growth(Step step, const Spring<>& spring, double h) {
  const State<double> end = measure::after(step, spring, spring.start(), h, 100'000);
  return spring.energy(end.x, end.v) / spring.energy(spring.x0, spring.v0);
}

// The largest departure from the position of rest, in terms of the start's.
template <class Step>
double farthest(Step step, const Spring<>& spring, double h) {
  double most = 0;
  State<double> s = spring.start();
  measure::run(step, spring, s, h, 100'000, [&most](double, const State<double>& now) {
    most = std::max(most, std::abs(now.x));
  });
  return most / std::abs(spring.x0);
}

template <class Step>
void check_drag_limit(Step step, double c) {
  const LinearDrag<> leaf{.c = c, .v0 = 3};
  const double inside = measure::after(step, leaf, leaf.start(), 1.99 / c, 5000).v;
  CHECK_THAT(inside, WithinRel(-leaf.terminal_speed(), 1e-13));
  const double outside = measure::after(step, leaf, leaf.start(), 2.01 / c, 5000).v;
  CHECK(std::abs(outside) > 1e6);
}

}  // namespace

TEST_CASE("Euler finds the terminal speed while c h < 2, and blows up beyond") {
  for (const double c : {0.5, 20.0}) check_drag_limit(measure::euler, c);
}

TEST_CASE("So does the exact step of a constant acceleration: its velocity is Euler's") {
  for (const double c : {0.5, 20.0}) check_drag_limit(measure::constant_acceleration, c);
}

TEST_CASE("Euler on drag alternates around the terminal speed when c h is between 1 and 2") {
  const LinearDrag<> leaf{.c = 2};
  double x = 0, v = 0;
  for (int n = 0; n < 10; ++n) {
    integrate::euler(x, v, 0.0, 0.75, leaf);
    CHECK((v < -leaf.terminal_speed()) == (n % 2 == 0));
  }
}

TEST_CASE(
    "Euler on a damped spring is stable below 2 zeta / omega, or below the fast decay's limit") {
  const struct {
    double zeta, limit;
  } springs[] = {{0.1, 0.2}, {0.5, 1}, {1, 2}, {2, 2 * (2 - std::sqrt(3))}};
  for (const auto& [zeta, limit] : springs) {
    for (const double omega : {1.0, 30.0}) {
      CAPTURE(zeta, omega);
      const Spring<> spring{.omega = omega, .zeta = zeta, .x0 = 0.5, .v0 = -0.3};
      CHECK(growth(measure::euler, spring, 0.99 * limit / omega) < 1e-6);
      CHECK_FALSE(growth(measure::euler, spring, 1.01 * limit / omega) < 1e6);
    }
  }
}

TEST_CASE("Euler gives an undamped spring 1 + (h omega)^2 times its energy on every step") {
  for (const double h_omega : {1e-3, 0.1, 1.0, 5.0}) {
    const Spring<> spring{.omega = 7};
    double x = 0.3, v = -2;
    for (int n = 0; n < 100; ++n) {
      const double before = spring.energy(x, v);
      integrate::euler(x, v, 0.0, h_omega / 7, spring);
      CHECK_THAT(spring.energy(x, v) / before, WithinRel(1 + h_omega * h_omega, 1e-13));
    }
  }
}

TEST_CASE("A constant acceleration per step makes an undamped spring grow with every step, too") {
  // The step's matrix has determinant 1 + (h omega)^2 / 2, the square of the growth.
  for (const double h_omega : {0.01, 0.1, 1.0}) {
    const Spring<> spring{.omega = 7};
    const double radius =
        measure::spectral_radius(measure::constant_acceleration, spring, h_omega / 7);
    CHECK_THAT(radius * radius, WithinRel(1 + h_omega * h_omega / 2, 1e-13));
    CHECK_FALSE(growth(measure::constant_acceleration, spring, 0.1 / 7) < 1e6);
  }
}

TEST_CASE("Symplectic Euler keeps an undamped spring bounded while h omega < 2, and not beyond") {
  for (const double omega : {1.0, 30.0}) {
    const Spring<> spring{.omega = omega, .x0 = 0.5};
    CHECK(farthest(measure::symplectic_euler, spring, 0.1 / omega) < 1.01);
    CHECK(farthest(measure::symplectic_euler, spring, 1.99 / omega) < 12);
    CHECK_FALSE(farthest(measure::symplectic_euler, spring, 2.01 / omega) < 1e6);
  }
}

TEST_CASE("Symplectic Euler keeps an energy of its own: v^2 + omega^2 x (x - h v)") {
  const double omega = 7;
  const Spring<> spring{.omega = omega};
  for (const double h : {0.01, 0.2}) {
    const auto kept = [&](double x, double v) { return v * v + omega * omega * x * (x - h * v); };
    double x = 0.3, v = -2;
    const double first = kept(x, v);
    for (int n = 0; n < 10'000; ++n) integrate::symplectic_euler(x, v, 0.0, h, spring);
    CHECK_THAT(kept(x, v), WithinRel(first, 1e-11));
  }
}

TEST_CASE("Damping makes symplectic Euler less stable: h omega < 2 (sqrt(1 + zeta^2) - zeta)") {
  for (const double zeta : {0.1, 0.5, 1.0, 2.0}) {
    CAPTURE(zeta);
    const double limit = 2 * (std::sqrt(1 + zeta * zeta) - zeta);
    const Spring<> spring{.omega = 3, .zeta = zeta, .x0 = 0.5, .v0 = -0.3};
    CHECK(growth(measure::symplectic_euler, spring, 0.99 * limit / 3) < 1e-6);
    CHECK_FALSE(growth(measure::symplectic_euler, spring, 1.01 * limit / 3) < 1e6);
  }
}
