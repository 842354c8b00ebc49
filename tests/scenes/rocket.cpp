// SPDX-License-Identifier: MIT-0
#include "scenes/rocket.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "equation.h"

using Catch::Matchers::WithinRel;

// The default rocket, its thrust integrated by quadrature: see reference.py.
TEST_CASE("A rocket has the speed and height that its thrust adds up to") {
  const scenes::Rocket<> rocket;
  CHECK_THAT(rocket.exact(1.5).x, WithinRel(10.01192805179750353, 1e-13));
  CHECK_THAT(rocket.exact(1.5).v, WithinRel(14.354511068954230226, 1e-14));
  CHECK_THAT(rocket.exact(4).x, WithinRel(93.357578886430626726, 1e-14));
  CHECK_THAT(rocket.exact(4).v, WithinRel(57.800605278392343318, 1e-14));
  CHECK_THAT(rocket.exact(6).x, WithinRel(189.33878944321531336, 1e-14));
  CHECK_THAT(rocket.exact(6).v, WithinRel(38.180605278392343318, 1e-14));
}

TEST_CASE("A rocket obeys its equation before and after burnout") {
  const scenes::Rocket<long double> rocket;
  for (const long double t : {0.1L, 2.0L, 3.9L, 4.1L, 9.0L}) {
    CAPTURE(t);
    CHECK(equation::residual(rocket, t) < 1e-13L);
  }
  CHECK(equation::begins_at_start(rocket));
}

TEST_CASE("At burnout a rocket's acceleration jumps, its speed and its height do not") {
  const scenes::Rocket<> rocket;
  const double before = std::nextafter(rocket.burn_time, 0.0);
  CHECK_THAT(rocket(0.0, 0.0, before), WithinRel(35 - 9.81, 1e-14));
  CHECK(rocket(0.0, 0.0, rocket.burn_time) == -9.81);
  CHECK_THAT(rocket.exact(before).x, WithinRel(rocket.exact(rocket.burn_time).x, 1e-14));
  CHECK_THAT(rocket.exact(before).v, WithinRel(rocket.exact(rocket.burn_time).v, 1e-14));
}
