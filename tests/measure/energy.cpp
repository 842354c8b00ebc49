// SPDX-License-Identifier: MIT-0
#include "measure/energy.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "made_up.h"

using Catch::Matchers::WithinRel;

namespace {

double doubled(double, double v) {
  return 2 * v;
}
double negative(double, double v) {
  return -v;
}

}  // namespace

TEST_CASE("A quantity that grows by a tenth on every step is seen to do so") {
  const auto growing = made_up::scaling([](double) { return 1.1; });
  const auto found = measure::drift(growing, made_up::Drifter(), 0.5, 10, doubled);
  CHECK_THAT(found.last, WithinRel(std::pow(1.1, 10) - 1, 1e-13));
  CHECK(found.largest == found.last);
  CHECK_THAT(found.smallest_gain, WithinRel(0.1, 1e-13));
}

TEST_CASE("The largest departure counts, up or down, and the last keeps its sign") {
  // 1, 2, 4, 1, 0.5: the largest departure is 3, the last is -1/2, the worst step loses 3/4.
  const auto swinging = made_up::scaling([](double t) { return t < 2 ? 2 : t < 3 ? 0.25 : 0.5; });
  const auto found = measure::drift(swinging, made_up::Drifter(), 1.0, 4, doubled);
  CHECK(found.largest == 3);
  CHECK(found.last == -0.5);
  CHECK(found.smallest_gain == -0.75);
}

TEST_CASE("A loss counts as a departure") {
  // 1, 0.25, 1.5
  const auto dipping = made_up::scaling([](double t) { return t < 1 ? 0.25 : 6; });
  CHECK(measure::drift(dipping, made_up::Drifter(), 1.0, 2, doubled).largest == 0.75);
}

TEST_CASE("A negative energy that rises has a gain above zero") {
  const auto shrinking = made_up::scaling([](double) { return 0.75; });
  const auto found = measure::drift(shrinking, made_up::Drifter(), 1.0, 2, negative);
  CHECK(found.last == 1 - 0.75 * 0.75);
  CHECK(found.smallest_gain == 0.25);
}

TEST_CASE("A quantity that is kept to the last bit has no drift") {
  const auto resting = made_up::scaling([](double) { return 1; });
  const auto found = measure::drift(resting, made_up::Drifter(), 1.0, 5, doubled);
  CHECK(found.largest == 0);
  CHECK(found.last == 0);
  CHECK(found.smallest_gain == 0);
}

TEST_CASE("A run that is not a number has no small drift") {
  const auto broken = made_up::scaling([](double) { return NAN; });
  const auto found = measure::drift(broken, made_up::Drifter(), 1.0, 4, doubled);
  CHECK(std::isnan(found.largest));
  CHECK(std::isnan(found.smallest_gain));
}
