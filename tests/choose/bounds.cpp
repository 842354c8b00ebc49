// SPDX-License-Identifier: MIT-0
#include "choose/bounds.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_vector.hpp>
#include <vector>

using Catch::Matchers::Approx;

TEST_CASE("The roughest stretch of a log is where its longest frames are") {
  const std::vector<double> log{1, 1, 5, 1, 1, 4, 4, 1};
  CHECK(roughest(log, 1) == 2);
  CHECK(roughest(log, 2) == 5);
  CHECK(roughest(log, 5) == 2);
  CHECK(roughest(log, 8) == 0);
  CHECK(roughest(log, 9) == 0);
  CHECK(roughest({2, 2, 2, 2}, 2) == 0);
}

TEST_CASE("Uneven frames keep the mean that is asked for over the whole log") {
  const Bounds bounds{.hz = 100, .seconds = 0.04, .log = {"log", {0.1, 0.3, 0.1, 0.1}}};
  CHECK_THAT(uneven_frames(bounds),
             Approx(std::vector<double>{0, 0.01 * 2 / 3, 0.08 / 3, 0.1 / 3, 0.04}));
}

TEST_CASE("Of a long log the roughest stretch is taken, and a short one is taken again") {
  const Bounds part{.hz = 100, .seconds = 0.02, .log = {"log", {0.01, 0.01, 0.01, 0.02, 0}}};
  CHECK_THAT(uneven_frames(part), Approx(std::vector<double>{0, 0.01, 0.03}));
  const Bounds twice{.hz = 100, .seconds = 0.04, .log = {"log", {0.015, 0.005}}};
  CHECK_THAT(uneven_frames(twice), Approx(std::vector<double>{0, 0.015, 0.02, 0.035, 0.04}));
}
