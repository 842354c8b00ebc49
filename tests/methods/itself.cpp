// SPDX-License-Identifier: MIT-0
// Each method against its textbook formula, on coarse steps, where no two methods look alike.
#include <Eigen/Core>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <vector>

#include "integrate/constant_acceleration.h"
#include "integrate/euler.h"
#include "integrate/symplectic_euler.h"

using Catch::Matchers::WithinRel;

namespace {

// Not linear, and with every argument in it.
double pushed(double x, double v, double t) {
  return 0.3 - x * x * x - 0.4 * std::abs(v) * v + std::sin(1.7 * t) * (1 + 0.2 * x * v);
}

}  // namespace

TEST_CASE("Euler is z + h f(t, z) for the pair z of position and velocity") {
  for (const double h : {0.3, -0.2}) {
    double x = 0.7, v = -1.1;
    Eigen::Vector2d z{x, v};
    for (int n = 0; n < 8; ++n) {
      const double t = 0.25 + n * h;
      integrate::euler(x, v, t, h, pushed);
      z += h * Eigen::Vector2d(z[1], pushed(z[0], z[1], t));
      CAPTURE(h, n);
      CHECK_THAT(x, WithinRel(z[0], 1e-12));
      CHECK_THAT(v, WithinRel(z[1], 1e-12));
    }
  }
}

TEST_CASE("Symplectic Euler moves by h v + h^2 a, and its velocity is the distance over h") {
  for (const double h : {0.3, -0.2}) {
    double x = 0.7, v = -1.1;
    double at = x, speed = v;
    for (int n = 0; n < 8; ++n) {
      const double t = 0.25 + n * h;
      integrate::symplectic_euler(x, v, t, h, pushed);
      const double next = at + h * speed + h * h * pushed(at, speed, t);
      speed = (next - at) / h;
      at = next;
      CAPTURE(h, n);
      CHECK_THAT(x, WithinRel(at, 1e-12));
      CHECK_THAT(v, WithinRel(speed, 1e-12));
    }
  }
}

TEST_CASE("The exact step of a constant acceleration moves with the mean of its two velocities") {
  for (const double h : {0.3, -0.2}) {
    double x = 0.7, v = -1.1;
    double at = x, speed = v;
    for (int n = 0; n < 8; ++n) {
      const double t = 0.25 + n * h;
      integrate::constant_acceleration(x, v, t, h, pushed);
      const double faster = speed + h * pushed(at, speed, t);
      at += h * (speed + faster) / 2;
      speed = faster;
      CAPTURE(h, n);
      CHECK_THAT(x, WithinRel(at, 1e-12));
      CHECK_THAT(v, WithinRel(speed, 1e-12));
    }
  }
}

TEST_CASE("A step of each method is what comes out by hand") {
  // At x = 1, v = 2, t = 1/2 the acceleration is -1 - 1 + 1/2 = -3/2, and h is 1/2.
  const auto simple = [](double x, double v, double t) { return -x * x * x - v / 2 + t; };
  double x = 1, v = 2;
  integrate::euler(x, v, 0.5, 0.5, simple);
  CHECK(x == 2);
  CHECK(v == 1.25);
  x = 1, v = 2;
  integrate::symplectic_euler(x, v, 0.5, 0.5, simple);
  CHECK(v == 1.25);
  CHECK(x == 1.625);
  x = 1, v = 2;
  integrate::constant_acceleration(x, v, 0.5, 0.5, simple);
  CHECK(v == 1.25);
  CHECK(x == 1.8125);
}

TEST_CASE("The methods of order 1 ask for the acceleration once, at the start of the step") {
  struct Asked {
    double x, v, t;
    bool operator==(const Asked&) const = default;
  };
  std::vector<Asked> asked;
  const auto remember = [&asked](double x, double v, double t) {
    asked.push_back({x, v, t});
    return 5.0;
  };
  double x = 1, v = 2;
  SECTION("Euler") {
    integrate::euler(x, v, 3.0, 0.5, remember);
  }
  SECTION("symplectic Euler") {
    integrate::symplectic_euler(x, v, 3.0, 0.5, remember);
  }
  SECTION("constant acceleration") {
    integrate::constant_acceleration(x, v, 3.0, 0.5, remember);
  }
  CHECK(asked == std::vector<Asked>{{1, 2, 3}});
}
