// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
TEST_CASE("x") {}
