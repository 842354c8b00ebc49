// SPDX-License-Identifier: MIT-0
#include "measure/order.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cstddef>
#include <utility>

#include "made_up.h"

using Catch::Matchers::WithinRel;

TEST_CASE("Halving the step measures the orders of a method that has them") {
  for (const auto& [in_x, in_v] : {std::pair{1, 1}, {2, 1}, {1, 2}, {3, 2}}) {
    const auto method = made_up::of_orders(in_x, in_v);
    const auto study = measure::halvings(method, made_up::Drifter(), 0.5, 4, 5);
    REQUIRE(study.size() == 5);
    CHECK(std::isnan(study[0].position_order));
    CHECK(std::isnan(study[0].velocity_order));
    for (std::size_t row = 0; row < study.size(); ++row) {
      const double h = std::pow(0.5, row + 1);
      CAPTURE(in_x, in_v, row);
      CHECK(study[row].h == h);
      CHECK_THAT(study[row].error.position, WithinRel(4 * std::pow(h, in_x), 1e-7));
      CHECK_THAT(study[row].error.velocity, WithinRel(12 * std::pow(h, in_v), 1e-7));
      if (row == 0) continue;
      CHECK_THAT(study[row].position_order, WithinRel(in_x, 1e-6));
      CHECK_THAT(study[row].velocity_order, WithinRel(in_v, 1e-6));
    }
  }
}
