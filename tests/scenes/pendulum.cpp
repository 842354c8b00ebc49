// SPDX-License-Identifier: MIT-0
#include "scenes/pendulum.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "equation.h"
#include "runge_kutta.h"

using Catch::Matchers::WithinRel;
using scenes::Pendulum;

// Legendre's integral by quadrature: see reference.py.
TEST_CASE("A pendulum's period is what the elliptic integral says") {
  CHECK_THAT(Pendulum<>{.angle = 0.1}.period(), WithinRel(2.0073211911753034982, 1e-15));
  CHECK_THAT(Pendulum<>{.angle = 1}.period(), WithinRel(2.1391376005586888448, 1e-15));
  CHECK_THAT(Pendulum<>{.angle = 3}.period(), WithinRel(5.1580667542678659132, 1e-15));
  CHECK(Pendulum<>{.angle = -3}.period() == Pendulum<>{.angle = 3}.period());
}

TEST_CASE("A small swing takes 2 pi sqrt(length / g), and a larger one longer") {
  const double small = 2 * std::numbers::pi * std::sqrt(2.5 / 1.62);
  CHECK_THAT((Pendulum<>{.g = 1.62, .length = 2.5, .angle = 0}.period()), WithinRel(small, 1e-15));
  for (const double angle : {0.01, 0.1}) {
    // The first terms of the series in the angle; the next is 11 angle^4 / 3072.
    const double longer = 1 + angle * angle / 16;
    const double period = Pendulum<>{.g = 1.62, .length = 2.5, .angle = angle}.period();
    CHECK_THAT(period, WithinRel(small * longer, 0.004 * std::pow(angle, 4) + 1e-15));
  }
}

// Taylor series of the differential equation: see reference.py.
TEST_CASE("A pendulum goes where its equation takes it") {
  const Pendulum<> pendulum;
  const auto early = runge_kutta(pendulum, pendulum.start(), 0.7, 2000);
  CHECK_THAT(early.x, WithinRel(-0.47458050090535446433, 1e-12));
  CHECK_THAT(early.v, WithinRel(-2.6174328222308211524, 1e-12));
  const auto late = runge_kutta(pendulum, pendulum.start(), 2.0, 4000);
  CHECK_THAT(late.x, WithinRel(0.92079382715597145732, 1e-12));
  CHECK_THAT(late.v, WithinRel(1.1283018575016757355, 1e-12));
}

TEST_CASE("After one period a pendulum is back, with the energy that it had") {
  const Pendulum<> pendulum{.g = 1.62, .length = 2.5, .angle = 3};
  const auto start = pendulum.start();
  const auto back = runge_kutta(pendulum, start, pendulum.period(), 20'000);
  CHECK_THAT(back.x, WithinRel(3.0, 1e-12));
  CHECK(std::abs(back.v) < 1e-11);
  for (const double part : {0.1, 0.3, 0.77}) {
    const auto now = runge_kutta(pendulum, start, part * pendulum.period(), 20'000);
    CHECK_THAT(pendulum.energy(now.x, now.v), WithinRel(pendulum.energy(start.x, start.v), 1e-12));
  }
}

TEST_CASE("A pendulum's energy is its height and its speed") {
  const Pendulum<> pendulum{.g = 10, .length = 2};
  CHECK(pendulum.energy(0.0, 0.0) == 0);
  CHECK_THAT(pendulum.energy(std::numbers::pi, 0.0), WithinRel(10 * 4.0, 1e-15));
  CHECK_THAT(pendulum.energy(std::numbers::pi / 2, 3.0), WithinRel(10 * 2 + 6 * 6 / 2.0, 1e-15));
}

TEST_CASE("A pendulum's acceleration can be a constant of the compiler") {
  constexpr double a = Pendulum<>{}(0.5, 0.0, 0.0);
  CHECK_THAT(a, WithinRel(-9.81 * 0.479425538604203, 1e-15));
}

TEST_CASE("A pendulum's exact solution obeys its equation") {
  for (const Pendulum<>& pendulum :
       {Pendulum<>{.g = 1.62, .length = 2.5, .angle = 3}, Pendulum<>{.angle = 0.01}}) {
    const auto x = [&](long double t) -> long double { return pendulum.exact(double(t)).x; };
    const auto v = [&](long double t) -> long double { return pendulum.exact(double(t)).v; };
    for (const double t : {-7.0, -0.3, 0.2, 1.0, 4.0, 50.0}) {
      const auto now = pendulum.exact(t);
      // Roundings of numbers up to 8, at times up to 50, over differences of a thousandth.
      CHECK(std::abs(equation::slope(x, t) - now.v) < 1e-10);
      CHECK(std::abs(equation::slope(v, t) - pendulum(now.x, now.v, t)) < 1e-10);
    }
  }
}

TEST_CASE("A pendulum's exact solution goes where its equation takes it") {
  const Pendulum<> pendulum;
  CHECK_THAT(pendulum.exact(0).x, WithinRel(pendulum.angle, 1e-15));
  CHECK(std::abs(pendulum.exact(0).v) < 1e-15);
  CHECK_THAT(pendulum.exact(0.7).x, WithinRel(-0.47458050090535446433, 1e-14));
  CHECK_THAT(pendulum.exact(0.7).v, WithinRel(-2.6174328222308211524, 1e-14));
  CHECK_THAT(pendulum.exact(2).x, WithinRel(0.92079382715597145732, 1e-14));
  CHECK_THAT(pendulum.exact(2).v, WithinRel(1.1283018575016757355, 1e-13));
  CHECK_THAT(pendulum.exact(-2).v, WithinRel(-pendulum.exact(2).v, 1e-15));
}

TEST_CASE("A pendulum that starts to the other side mirrors the first, and one at rest stays") {
  const Pendulum<> left{.angle = -1}, right{.angle = 1};
  CHECK(left.exact(0.4).x == -right.exact(0.4).x);
  CHECK(left.exact(0.4).v == -right.exact(0.4).v);
  CHECK((Pendulum<>{.angle = 0}).exact(3).x == 0);
}
