// SPDX-License-Identifier: MIT-0
#include "report/shortened.h"

#include <catch2/catch_test_macros.hpp>

using grade::shortened;
using grade::told_apart;

TEST_CASE("a long number is shown with six digits") {
  CHECK(shortened("x = 0.12345678901234567 m") == "x = 0.123457 m");
  CHECK(shortened("12 of 34.5") == "12 of 34.5");
  CHECK(shortened("1.2345678e-30") == "1.23457e-30");
}

TEST_CASE("what differs late is shown with the digits that it takes") {
  const auto [expected, got] =
      told_apart("x = (-1.2565612345678, 2)", "x = (-1.2565612399999, 2) after all");
  CHECK(expected == "x = (-1.25656123, 2)");
  CHECK(got == "x = (-1.25656124, 2) after all");
  CHECK(expected != got);
}

TEST_CASE("what differs early keeps six digits, and so does what does not differ at all") {
  CHECK(told_apart("1.2345678901", "1.3345678901").first == "1.23457");
  CHECK(told_apart("1.2345678901", "1.2345678901").second == "1.23457");
  CHECK(told_apart("five", "1.2345678901").second == "1.23457");
}
