// SPDX-License-Identifier: MIT-0
#include "scenes/spring.h"

#include <Eigen/Core>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "equation.h"

using Catch::Matchers::WithinRel;
using scenes::Spring;

// Taylor series of the differential equation: see reference.py.
TEST_CASE("A spring swings and creeps as its equation says, at every damping") {
  const struct {
    double zeta, x1, v1, x2, v2;
  } known[] = {
      {0, -0.82789596339917790626, -0.28512184077359575278,  //
       0.66636214212446692548, -1.5012173260023432319},
      {0.2, -0.48954118799824021982, -0.037269512989239816731,  //
       0.20699123545880390629, -0.42074432205581466667},
      {1, 0.018368464237947286533, -0.11633360684033281471,  //
       -0.0012393760883331792115, 0.002478752176666358423},
      {2.5, 0.24341069265976643607, -0.15248031253073151082,  //
       0.1078510596275137354, -0.067529480420489000756},
  };
  for (const auto& row : known) {
    CAPTURE(row.zeta);
    const Spring<> spring{.omega = 3, .zeta = row.zeta, .x0 = 0.5, .v0 = -2};
    CHECK_THAT(spring.exact(0.7).x, WithinRel(row.x1, 1e-13));
    CHECK_THAT(spring.exact(0.7).v, WithinRel(row.v1, 1e-13));
    CHECK_THAT(spring.exact(2).x, WithinRel(row.x2, 1e-13));
    CHECK_THAT(spring.exact(2).v, WithinRel(row.v2, 1e-13));
    CHECK(equation::begins_at_start(spring));
  }
}

TEST_CASE("A spring obeys its equation at every damping, before the start and after") {
  for (const long double zeta : {0.0L, 0.1L, 0.999999L, 1.0L, 1.000001L, 5.0L}) {
    const Spring<long double> spring{.omega = 2, .zeta = zeta, .x0 = 0.5L, .v0 = -2};
    for (const long double t : {-0.02L, 0.1L, 1.0L, 5.0L}) {
      CAPTURE(zeta, t);
      CHECK(equation::residual(spring, t) < 1e-12L);
    }
  }
}

TEST_CASE("Critical damping is the limit from both sides") {
  const Spring<> critical{.omega = 3, .zeta = 1, .x0 = 0.5, .v0 = -2};
  for (const double near : {1e-4, 1e-8, 1e-12, 1e-15}) {
    for (const double side : {-1.0, 1.0}) {
      Spring<> spring = critical;
      spring.zeta = 1 + side * near;
      CAPTURE(spring.zeta - 1);
      for (const double t : {0.2, 1.0, 4.0}) {
        CHECK(std::abs(spring.exact(t).x - critical.exact(t).x) < near + 1e-15);
        CHECK(std::abs(spring.exact(t).v - critical.exact(t).v) < 3 * near + 1e-15);
      }
    }
  }
}

// Two exponentials at 40 digits: see reference.py.
TEST_CASE("A door that is very stiff creeps home without losing digits") {
  const Spring<> door{.omega = 1e4, .zeta = 5e3};
  CHECK_THAT(door.exact(1).x, WithinRel(0.36787944117144233999, 1e-13));
  CHECK_THAT(door.exact(50).x, WithinRel(1.9287489028767050218e-22, 1e-13));
}

TEST_CASE("A spring's energy is conserved without damping and falls with it") {
  const Spring<> undamped{.omega = 3, .x0 = 0.5, .v0 = -2};
  Spring<> damped = undamped;
  damped.zeta = 0.1;
  double before = 3.125;
  for (int n = 1; n < 50; ++n) {
    const auto free = undamped.exact(0.37 * n);
    CHECK_THAT(undamped.energy(free.x, free.v), WithinRel(3.125, 1e-14));
    const auto lossy = damped.exact(0.37 * n);
    const double energy = damped.energy(lossy.x, lossy.v);
    CHECK(energy < before);
    before = energy;
  }
}

TEST_CASE("A spring pulls in any number of dimensions") {
  constexpr Spring<> spring{.omega = 3, .zeta = 0.5};
  STATIC_CHECK(spring(2.0, 1.0, 0.0) == -9.0 * 2 - 3 * 1);
  const Eigen::Vector3d a = spring(Eigen::Vector3d(1, 2, 0), Eigen::Vector3d(0, 1, 2), 0.0);
  CHECK(a == Eigen::Vector3d(-9, -21, -6));
}
