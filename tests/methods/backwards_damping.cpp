// SPDX-License-Identifier: MIT-0
// What a negative step does in the methods that damp: as much as their headers promise.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>

#include "integrate/backward_euler_spring.h"
#include "integrate/linear_damping.h"
#include "integrate/trapezoid.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double speed = -1.1;

// The velocity after one step, under a constant force.
template <class Step>
double after(const Step& step, double v, double h, double c, double force = 0) {
  double x = 0.7;
  step(x, v, 0.0, h, c, [force](double, double, double) { return force; });
  return v;
}

constexpr auto explicit_last = [](auto&&... p) { integrate::linear_damping_explicit_last(p...); };
constexpr auto explicit_first = [](auto&&... p) { integrate::linear_damping_explicit_first(p...); };
constexpr auto implicit_last = [](auto&&... p) { integrate::linear_damping_implicit_last(p...); };
constexpr auto implicit_first = [](auto&&... p) { integrate::linear_damping_implicit_first(p...); };
constexpr auto exponential_last = [](auto&&... p) {
  integrate::linear_damping_exponential_last(p...);
};
constexpr auto exponential_first = [](auto&&... p) {
  integrate::linear_damping_exponential_first(p...);
};
constexpr auto exact = [](auto&&... p) { integrate::linear_damping_exact(p...); };

// c h from a millionth to a hundred, at steps of games.
template <class Check>
void sweep(Check check) {
  for (const double h : {1 / 30.0, 1 / 60.0, 1 / 240.0}) {
    for (int n = 0; n <= 80; ++n) {
      const double c = std::pow(10.0, -6 + 0.1 * n) / h;
      CAPTURE(h, c, c * h);
      check(h, c);
    }
  }
}

// How far a step back of h is from the truth, which grows by e^(c h), in parts of the velocity.
template <class Step>
double miss(const Step& step, double h, double c) {
  return std::abs(after(step, speed, -h, c) / speed - std::exp(c * h));
}

}  // namespace

TEST_CASE("A negative step of every way to damp goes back in time, with an error of order one") {
  const auto check = [](const auto& step) {
    sweep([&](double h, double c) {
      if (c * h <= 0.3) CHECK(miss(step, h, c) <= c * h * c * h + 4 * epsilon);
    });
  };
  check(explicit_last);
  check(explicit_first);
  check(implicit_last);
  check(implicit_first);
  check(exponential_last);
  check(exponential_first);
  check(exact);
}

TEST_CASE(
    "A negative step of the explicit ways is finite for every c h, but no way out of a stop") {
  sweep([](double h, double c) {
    for (const auto& back :
         {after(explicit_last, speed, -h, c), after(explicit_first, speed, -h, c)}) {
      CHECK_THAT(back, WithinRel(speed * (1 + c * h), 4 * epsilon));
    }
    if (c * h < 1) return;
    CHECK(after(explicit_last, after(explicit_last, speed, h, c), -h, c) == 0);
    CHECK(after(explicit_first, after(explicit_first, speed, h, c), -h, c) == 0);
  });
}

TEST_CASE("A negative step of the implicit ways goes back while c h is below one, and no further") {
  sweep([](double h, double c) {
    for (const auto& back :
         {after(implicit_last, speed, -h, c), after(implicit_first, speed, -h, c)}) {
      if (c * h > 1 - 1e-9 && c * h < 1 + 1e-9) continue;
      CHECK((back < 0) == (c * h < 1));  // beyond, it has turned round
      if (c * h < 1) CHECK(std::abs(back) >= std::abs(speed) * std::exp(c * h) * (1 - 4 * epsilon));
    }
  });
  CHECK(std::isinf(after(implicit_last, speed, -0.25, 4)));
  CHECK(std::isinf(after(implicit_first, speed, -0.25, 4)));
}

TEST_CASE("A negative step of the exponential ways takes back the damping, whatever c h") {
  sweep([](double h, double c) {
    const auto check = [&](const auto& step) {
      CHECK_THAT(after(step, after(step, speed, h, c), -h, c), WithinRel(speed, 8 * epsilon));
    };
    check(exponential_last);
    check(exponential_first);
    check(exact);
  });
}

TEST_CASE("A negative step of linear_damping_exact takes back a constant force as well") {
  sweep([](double h, double c) {
    if (c * h > 30) return;  // by then the force alone is left, and nothing of the speed before
    const double force = -9.81;
    const double back = after(exact, after(exact, speed, h, c, force), -h, c, force);
    const double kick = std::abs(force) * (c > 1 ? 1 / c : h);
    CHECK_THAT(back, WithinAbs(speed, 8 * epsilon * (std::abs(speed) + kick) * std::exp(c * h)));
  });
}

TEST_CASE(
    "A negative step of implicit Euler on a spring goes back up to its pole, from zeta 1 on") {
  const auto place = [](double h, double omega, double zeta) {
    double x = 1, v = 0;
    integrate::backward_euler_spring(x, v, h, omega, zeta);
    return x;
  };
  CHECK(std::isinf(place(-0.25, 4, 1)));
  for (const double zeta : {1.0, 1.25, 3.0}) {
    const double pole = zeta - std::sqrt(zeta * zeta - 1);
    CHECK(std::abs(place(-0.999999 * pole / 8, 8, zeta)) > 1e4);
    for (int n = 0; n <= 50; ++n) {
      const double angle = 0.5 * pole * std::pow(10.0, -6 + 0.12 * n);
      CAPTURE(zeta, angle);
      // The truth is 1 - angle^2 / 2 and more of higher order, with zeta in it.
      CHECK(std::abs(place(-angle / 8, 8, zeta) - 1) <= 4 * angle * angle / (1 - 0.5) * zeta);
    }
  }
  for (const double zeta : {0.0, 0.1, 0.9}) {
    for (int n = 0; n <= 80; ++n) {
      const double angle = std::pow(10.0, -6 + 0.1 * n);
      CAPTURE(zeta, angle);
      CHECK(std::abs(place(-angle / 8, 8, zeta)) <= (1 + 2 * zeta) / (1 - zeta * zeta));
    }
  }
}

TEST_CASE("The trapezoid rule takes its own step back while c h is under 2, and refuses at 2") {
  const auto there_and_back = [](double c, double h, double v) {
    const auto drag = [c](double, double speed_now, double) { return -c * speed_now; };
    const auto solve = [c](double, double, double, double, double q, double& change) {
      const double pivot = 1 - q * c;
      change = change / pivot;
      return pivot != 0;
    };
    double x = 0;
    if (!integrate::trapezoid(x, v, 0.0, h, drag, solve))
      return std::numeric_limits<double>::infinity();
    if (!integrate::trapezoid(x, v, h, -h, drag, solve))
      return std::numeric_limits<double>::infinity();
    return v;
  };
  for (const double ch : {1e-6, 1e-3, 0.1, 1.0, 1.9}) {
    CAPTURE(ch);
    CHECK_THAT(there_and_back(60 * ch, 1 / 60.0, speed), WithinRel(speed, 1e-13));
  }
  CHECK(std::isinf(there_and_back(128, 1 / 64.0, speed)));
}
