// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

TEST_CASE("Euler gains energy on every step") {
  REQUIRE(1 < 2);
}

TEST_CASE("Nobody cites this claim") {
  CHECK(1 < 2);
}
