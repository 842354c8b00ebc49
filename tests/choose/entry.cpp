// SPDX-License-Identifier: MIT-0
#include "choose/entry.h"

#include <catch2/catch_test_macros.hpp>

namespace {

/// Within the bounds, for a price, with these errors.
Entry entry(const measure::Method& method, double evaluations, double error, double uneven) {
  Entry made;
  made.method = &method;
  made.good = true;
  made.evaluations = evaluations;
  made.last.error = error;
  made.uneven = uneven;
  return made;
}

}  // namespace

TEST_CASE("Of two that cost the same and err the same the better in uneven frames comes first") {
  const Bounds bounds{.error = 0.01};
  const Entry verlet = entry(method::velocity_verlet, 60, 0.001, 0.003);
  const Entry leapfrog = entry(method::leapfrog, 60, 0.001, 0.002);
  CHECK(better(leapfrog, verlet, bounds));
  CHECK_FALSE(better(verlet, leapfrog, bounds));
}

TEST_CASE("Rounding parts no equals, of which velocity Verlet comes first") {
  const Bounds bounds{.error = 0.01};
  const Entry verlet = entry(method::velocity_verlet, 60, 0.001, 0.002 + 1e-12);
  const Entry leapfrog = entry(method::leapfrog, 60, 0.001 - 1e-13, 0.002);
  CHECK(better(verlet, leapfrog, bounds));
  CHECK_FALSE(better(leapfrog, verlet, bounds));
}

TEST_CASE("What is right in uneven frames as well comes before what errs less in even ones") {
  const Bounds bounds{.error = 0.01};
  const Entry holds = entry(method::velocity_verlet, 60, 0.009, 0.0095);
  const Entry shaky = entry(method::rk4, 60, 0.0001, 0.02);
  CHECK(better(holds, shaky, bounds));
  CHECK_FALSE(better(shaky, holds, bounds));
}
