// SPDX-License-Identifier: MIT-0
// When a spring with a damping ratio of 1 or more passes its place of rest, and when it does not.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "integrate/backward_euler_spring.h"
#include "integrate/spring_exact.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr auto exact = [](double& x, double& v, double h, double omega, double zeta) {
  integrate::spring_exact(x, v, h, omega, zeta);
};
constexpr auto implicit = [](double& x, double& v, double h, double omega, double zeta) {
  integrate::backward_euler_spring(x, v, h, omega, zeta);
};

// How often a thing that starts at x = 1 passes its place of rest, in 40 / omega seconds or more.
template <class Step>
int passes(const Step& step, double v, double h, double omega, double zeta) {
  double x = 1;
  int count = 0;
  for (double t = 0; t < 40 / omega + 100 * h; t += h) {
    const bool before = x > 0;
    step(x, v, h, omega, zeta);
    if (before != (x > 0)) ++count;
  }
  return count;
}

template <class Check>
void for_springs_and_steps(Check check) {
  for (const double omega : {0.5, 8.0, 40.0}) {
    for (const double h : {1 / 1000.0, 1 / 60.0, 1 / 10.0}) {
      CAPTURE(omega, h);
      check(omega, h);
    }
  }
}

}  // namespace

TEST_CASE(
    "A critically damped spring overshoots only if it comes in faster than omega x, and once") {
  for_springs_and_steps([](double omega, double h) {
    for (const double part : {0.0, 0.5, 0.99}) {
      CHECK(passes(exact, -part * omega, h, omega, 1) == 0);
      CHECK(passes(implicit, -part * omega, h, omega, 1) == 0);
      CHECK(passes(exact, part * omega, h, omega, 1) == 0);
      CHECK(passes(implicit, part * omega, h, omega, 1) == 0);
    }
    for (const double part : {1.1, 1.5, 2.5, 40.0}) {  // it passes after 1 / ((part - 1) omega)
      CAPTURE(part);
      CHECK(passes(exact, -part * omega, h, omega, 1) == 1);
      CHECK(passes(implicit, -part * omega, h, omega, 1) == 1);
    }
  });
}

TEST_CASE("With more damping it does not overshoot either, unless it comes in faster than that") {
  for (const double zeta : {1.01, 2.0, 10.0}) {
    const double fast = zeta + std::sqrt(zeta * zeta - 1);  // the faster of its two rates, by omega
    for_springs_and_steps([&](double omega, double h) {
      CAPTURE(zeta);
      for (const double part : {0.0, 1.0, 0.99 * fast}) {
        CHECK(passes(exact, -part * omega, h, omega, zeta) == 0);
        CHECK(passes(implicit, -part * omega, h, omega, zeta) == 0);
      }
      CHECK(passes(exact, -1.5 * fast * omega, h, omega, zeta) == 1);
      CHECK(passes(implicit, -1.5 * fast * omega, h, omega, zeta) == 1);
    });
  }
}

TEST_CASE("A camera that comes in at 20 m/s, where 8 would do, is 0.28 m beyond its target") {
  // x = (1 - 12 t) exp(-8 t), the furthest at t = 5/24.
  double x = 1, v = -20, least = 1;
  for (int n = 0; n < 1000; ++n) {
    exact(x, v, 1 / 1000.0, 8, 1);
    least = std::min(least, x);
  }
  CHECK_THAT(least, WithinRel(-1.5 * std::exp(-5 / 3.0), 1e-4));
  CHECK_THAT(least, WithinAbs(-0.283, 5e-4));
}
