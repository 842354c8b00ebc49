// SPDX-License-Identifier: MIT-0
// The limit that a live figure marks on its slider is the one that the chapters measure.
#include "live/step_limit.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>

#include "measure/methods/euler.h"
#include "measure/methods/runge_kutta.h"
#include "measure/stability.h"
#include "scenes/spring.h"

using Catch::Matchers::WithinRel;

namespace {

// Both halve the same range 60 times, so they differ by what rounding does to an eigenvalue: a few
// units in the last place of the largest entry of the step's matrix, h omega^2, here at most 100.
// At critical damping two eigenvalues meet, and an error moves them by its square root.
template <class Step>
void check_same_limit(Step step) {
  const double rounding = 100 * std::numeric_limits<double>::epsilon();
  for (const double zeta : {0.05, 0.1, 0.5, 0.9, 1.0, 1.2}) {
    const scenes::Spring<> spring{.omega = 20, .zeta = zeta};
    const double chapters = measure::stability_limit(step, spring, 1e-4, 0.25);
    const double allowed = zeta == 1 ? std::sqrt(rounding) : 100 * rounding;
    CHECK_THAT(live::step_limit(step, spring, 1e-4, 0.25), WithinRel(chapters, allowed));
  }
}

}  // namespace

TEST_CASE("The limit on the page is the limit of the chapters") {
  check_same_limit(measure::euler);
  check_same_limit(measure::symplectic_euler);
  check_same_limit(measure::rk4);
}

TEST_CASE("On the page, too, Euler has no stable step on an undamped spring") {
  const scenes::Spring<> undamped{.omega = 20};
  CHECK(live::step_limit(measure::euler, undamped, 1e-4, 0.25) < 1.01e-4);
}
