// SPDX-License-Identifier: MIT-0
// What the page of forces says.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "forces.h"
#include "integrate/rk4.h"
#include "integrate/symplectic_euler.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("A box of half the density of water comes to rest half under, braked by water") {
  double z = 0.3, v = 0;
  for (int n = 0; n < 60 * 20; ++n) {
    const double h = 1 / 60.0, c = z < 0 ? 2 : 0;
    v = (v + h * buoyancy(z, 0.6, 0.5)) / (1 + h * c);
    z += h * v;
  }
  CHECK_THAT(z, WithinAbs(-0.3, 1e-6));
}

TEST_CASE("A floating box bobs at sqrt(g / (density height))") {
  const double height = 0.6, density = 0.7, omega = std::sqrt(9.81 / (density * height));
  double z = -density * height + 0.05, v = 0;
  const double period = 2 * std::acos(-1.0) / omega;
  for (int n = 0; n < 1000; ++n) {
    integrate::rk4(z, v, 0.0, period / 1000,
                   [&](double place, double, double) { return buoyancy(place, height, density); });
  }
  CHECK_THAT(z, WithinAbs(-density * height + 0.05, 1e-9));
  CHECK_THAT(v, WithinAbs(0, 1e-9));
}

TEST_CASE(
    "A rocket that burns nine tenths of its mass gains 2.30 times its exhaust speed, and RK4 "
    "misses none of it") {
  const Vec nose(0, 0, 1);
  const double burn = 9, exhaust = 2000;
  Vec x(0, 0, 0), v(0, 0, 0);
  double mass = 100;
  for (int n = 0; n < 600; ++n) {
    integrate::rk4(x, v, n / 60.0, 1 / 60.0, [&](const Vec&, const Vec&, double t) {
      return thrust(nose, exhaust, burn, 100 - burn * t);
    });
    mass -= burn / 60;
  }
  CHECK_THAT(mass, WithinRel(10.0, 1e-9));
  CHECK_THAT(v.z(), WithinRel(exhaust * std::log(10.0), 1e-6));
  CHECK_THAT(std::log(10.0), WithinAbs(2.30, 0.005));
}

TEST_CASE(
    "By an inverse square a coin that falls into a player is thrown out faster than it came, and "
    "with softness no faster") {
  const auto fastest = [](double softness) {
    Vec x(3, 0.001, 0), v(0, 0, 0);
    double energy = 0;
    for (int n = 0; n < 60 * 4; ++n) {
      integrate::symplectic_euler(x, v, 0.0, 1 / 60.0, [&](const Vec& place, const Vec&, double) {
        if (softness > 0) return magnet(Vec(-place), 12, softness);
        return Vec(-8 / (place.squaredNorm() * place.norm()) * place);
      });
      if (x.norm() > 2.5) energy = std::max(energy, v.norm());
    }
    return energy;
  };
  CHECK(fastest(0) > 10);
  CHECK(fastest(0.5) < 4);
  for (const double far : {0.1, 0.2, 0.35, 0.5, 1.0}) {
    CHECK(magnet(Vec(far, 0, 0), 12, 0.5).x() <= 12);
  }
  CHECK_THAT(magnet(Vec(0.5 / std::sqrt(2.0), 0, 0), 12, 0.5).x(), WithinRel(12.0, 1e-4));
  CHECK(magnet(Vec(0, 0, 0), 12, 0.5).norm() == 0);
}

TEST_CASE("Blown by 8 m/s a leaf ends at 8 m/s and falls with g / c, at 15 to 240 Hz") {
  for (const int rate : {15, 30, 60, 240}) {
    Vec x(0, 0, 50), v(0, 0, 0);
    for (int n = 0; n < 10 * rate; ++n) {
      blown(x, v, Vec(0, 0, -9.81), Vec(8, 0, 0), 4, 1.0 / rate);
    }
    CHECK_THAT(v.x(), WithinRel(8.0, 1e-9));
    CHECK_THAT(v.z(), WithinRel(-9.81 / 4, 1e-9));
  }
}

TEST_CASE(
    "A homing missile of 60 m/s hits what stands and what crosses at 20 m/s, within a metre, at 15 "
    "to 240 Hz") {
  for (const int rate : {15, 30, 60, 240}) {
    for (const double crosses : {0.0, 20.0}) {
      CAPTURE(rate, crosses);
      Vec x(0, 0, 0), v(0, 25, 0), target(120, 0, 10);
      const Vec moves(0, crosses, 0);
      const double h = 1.0 / rate;
      double nearest = 1e9;
      for (int n = 0; n < 6 * rate; ++n) {
        integrate::symplectic_euler(x, v, 0.0, h, [&](const Vec& place, const Vec& u, double) {
          return homing(Vec(target - place), u, moves, 60, 60);
        });
        const Vec before = target - (x - h * v);
        target += h * moves;
        // Between two ticks, as a ray from one to the next would see it.
        const Vec relative = h * (v - moves);
        const double share = std::clamp(before.dot(relative) / relative.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (before - share * relative).norm());
      }
      CHECK(nearest < 1);
    }
  }
}
