// SPDX-License-Identifier: MIT-0
// Chapter 7: a wheel and its chassis over a kerb.
#include <Eigen/Core>
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstddef>

#include "choose/entrants.h"
#include "kerb.h"
#include "measure/methods.h"
#include "measure/stability.h"

using measure::Method;
using method::euler;
using method::rk4;
using method::symplectic_euler;
using method::velocity_verlet;

TEST_CASE("After the kerb the wheel leaves the road") {
  for (const auto& [corner, truth] : kerbs()) {
    const auto in_the_air = [&, frames = std::size_t(0)](const Eigen::Vector2d& x) mutable {
      return corner.push(x[1], double(frames++) * frame) == -Corner::weight;
    };
    CHECK(std::any_of(truth.begin(), truth.end(), in_the_air));
  }
}

TEST_CASE("The truth over the kerb is that of very short steps") {
  CHECK(worst_over_kerb(rk4, 300) < 1e-7);
}

TEST_CASE("The derivatives of a corner are those of its acceleration, on the road and in the air") {
  const Corner corner;
  for (const Eigen::Vector2d& x : {Eigen::Vector2d(0.01, 0.002), Eigen::Vector2d(0.01, 0.03)}) {
    const Eigen::Vector2d v(0.1, -0.2);
    Eigen::Matrix2d by_x = Eigen::Matrix2d::Zero(), by_v = by_x;
    corner.jacobian(x, v, 0.0, [&](int i, int j, double dx, double dv) {
      by_x(i, j) += dx;
      by_v(i, j) += dv;
    });
    for (int j = 0; j < 2; ++j) {
      const Eigen::Vector2d little = 1e-5 * Eigen::Vector2d::Unit(j);
      const Eigen::Vector2d slope =
          (corner(x + little, v, 0.0) - corner(x - little, v, 0.0)) / 2e-5;
      CHECK((slope - by_x.col(j)).norm() < 1e-4);
      const Eigen::Vector2d brake =
          (corner(x, v + little, 0.0) - corner(x, v - little, 0.0)) / 2e-5;
      CHECK((brake - by_v.col(j)).norm() < 1e-5);
    }
  }
}

TEST_CASE(
    "Over the kerb velocity Verlet loses the wheel in one step a frame, and symplectic Euler with "
    "the damper divided holds it") {
  CHECK(worst_over_kerb(velocity_verlet, 1) > 0.5);
  CHECK(worst_over_kerb(symplectic_euler, 1) < 0.05);
  CHECK(worst_over_kerb(DamperDivided(), 1) < 0.05);
  CHECK(worst_over_kerb(euler, 1) > 0.2);
  const double much = strong * Corner().damper;
  CHECK(worst_over_kerb(symplectic_euler, 1, much) > 0.5);
  CHECK(worst_over_kerb(DamperDivided(), 1, much) < 0.05);
  CHECK(worst_over_kerb(StrutSoft(), 1, much) < 0.1);
}

TEST_CASE(
    "Over the kerb velocity Verlet is nearest of those that ask once from two steps a frame on") {
  for (const int in_a_frame : {2, 3, 4, 6, 8, 12}) {
    const double verlet = worst_over_kerb(velocity_verlet, in_a_frame);
    CAPTURE(in_a_frame);
    for (const Method* entrant : entrants) {
      if (evaluations_per_step(*entrant) > 1 || entrant == &velocity_verlet) continue;
      INFO(entrant->name);
      CHECK(2 * verlet < worst_over_kerb(*entrant, in_a_frame));
    }
    CHECK(2 * verlet < worst_over_kerb(DamperDivided(), in_a_frame));
    CHECK(2 * verlet < worst_over_kerb(StrutSoft(), in_a_frame));
  }
}

TEST_CASE(
    "Over the kerb the damper decides from how many steps a frame on velocity Verlet holds the "
    "wheel") {
  const double half = Corner().damper / 2, much = strong * Corner().damper;
  const double verlet = worst_over_kerb(velocity_verlet, 1, half),
               swapped = worst_over_kerb(symplectic_euler, 1, half),
               divided = worst_over_kerb(DamperDivided(), 1, half);
  CHECK(verlet < swapped);
  CHECK(verlet < divided);
  CHECK(swapped < divided);
  for (const int in_a_frame : {2, 3}) {
    CAPTURE(in_a_frame);
    CHECK(worst_over_kerb(velocity_verlet, in_a_frame, much) > 0.5);
    CHECK(worst_over_kerb(DamperDivided(), in_a_frame, much) < 0.02);
  }
}

TEST_CASE(
    "Over the kerb leapfrog, position Verlet and drift, kick, drift hold the wheel in one step a "
    "frame") {
  const double swapped = worst_over_kerb(symplectic_euler, 1);
  CHECK(worst_over_kerb(measure::leapfrog_drift, 1) < swapped);
  for (const Method* step : {&method::leapfrog, &method::stormer_verlet})
    CHECK(std::abs(worst_over_kerb(*step, 1) - swapped) < 1e-9);
  // As its limits say.
  for (const double zeta : {0.0, 0.1, 0.5, 1.0}) {
    const scenes::Spring<> spring{.omega = 1, .zeta = zeta};
    const double own = measure::stability_limit(measure::leapfrog_drift, spring, 1e-3, 4);
    CHECK(std::abs(own - measure::stability_limit(measure::symplectic_euler, spring, 1e-3, 4)) <
          1e-9);
  }
}

TEST_CASE(
    "Over the kerb RK4 is farther off than velocity Verlet at the same price, in up to four steps "
    "a frame") {
  for (const int in_a_frame : {1, 2, 3, 4}) {
    CAPTURE(in_a_frame);
    CHECK(worst_over_kerb(rk4, in_a_frame) > worst_over_kerb(velocity_verlet, 4 * in_a_frame));
  }
  CHECK(worst_over_kerb(rk4, 5) < worst_over_kerb(velocity_verlet, 20));
  CHECK(worst_over_kerb(rk4, 6) > worst_over_kerb(velocity_verlet, 24));
}
