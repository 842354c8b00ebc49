// SPDX-License-Identifier: MIT-0
#include "shelf/fixed_step.h"

#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include "frames/recorded.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using shelf::FixedStep;

TEMPLATE_TEST_CASE("Every step starts where the one before ended", "", float, double) {
  FixedStep<TestType> clock{.h = TestType(0.25)};
  std::vector<TestType> starts;
  for (const double frame : {0.125, 0.125, 0.0625, 0.1875, 0.25, 0.2}) {
    clock.frame(TestType(frame), [&](TestType t) { starts.push_back(t); });
  }
  CHECK(starts == std::vector<TestType>{0, TestType(0.25), TestType(0.5)});
  CHECK(clock.steps == 3);
  CHECK_THAT(clock.saved, WithinAbs(TestType(0.2), TestType(1e-6)));
  CHECK_THAT(clock.blend(), WithinRel(TestType(0.8), TestType(1e-6)));
}

TEST_CASE("Steps and saved time add up to the time of uneven frames") {
  frames::Playback frame;
  FixedStep<> clock;
  double total = 0;
  for (int n = 0; n < 10'000; ++n) {
    const double length = frame.next();
    total += length;
    clock.frame(length, [](double) {});
    REQUIRE(clock.saved >= 0);
    REQUIRE(clock.saved < clock.h);
  }
  CHECK_THAT(double(clock.steps) * clock.h + clock.saved, WithinRel(total, 1e-12));
}

TEST_CASE("Where a long has 32 bits, too, a server counts its steps for longer than a month") {
  STATIC_CHECK(std::is_same_v<decltype(FixedStep<>::steps), long long>);
}

TEST_CASE("A clock that was set back takes no steps and loses none") {
  FixedStep<> clock{.saved = 0.01};
  int steps = 0;
  clock.frame(-3600, [&](double) { ++steps; });
  CHECK(steps == 0);
  CHECK(clock.saved == 0.01);
}

TEMPLATE_TEST_CASE("A frame whose length is not a number takes no steps and stops no clock", "",
                   float, double) {
  using Limits = std::numeric_limits<TestType>;
  FixedStep<TestType> clock{.h = TestType(0.125), .saved = TestType(0.0625)};
  int steps = 0;
  const auto count = [&](TestType) { ++steps; };
  for (const TestType length : {Limits::quiet_NaN(), -Limits::quiet_NaN(), -Limits::infinity()}) {
    clock.frame(length, count);
    CHECK(steps == 0);
    CHECK(clock.saved == TestType(0.0625));
  }
  clock.frame(TestType(0.125), count);
  CHECK(steps == 1);
  CHECK(clock.blend() == TestType(0.5));
}

TEST_CASE("A frame longer than the longest is cut, and the next frame is on time again") {
  FixedStep<> clock{.h = 0.125, .longest_frame = 0.25};
  int steps = 0;
  const auto count = [&](double) { ++steps; };
  clock.frame(std::numeric_limits<double>::infinity(), count);
  CHECK(steps == 2);
  clock.frame(0.125, count);
  CHECK(steps == 3);
  CHECK(clock.saved == 0);
}

TEST_CASE(
    "The clock of a step stays even for a day in double, and in float for less than an hour") {
  const auto uneven = [](auto clock, long hours) {
    clock.steps = 60L * 3600 * hours;
    double before = 0, most = 0;
    for (int n = 0; n < 600; ++n) {
      clock.frame(clock.h, [&](auto t) {
        if (before > 0) most = std::max(most, std::abs(double(t) - before - 1.0 / 60));
        before = double(t);
      });
    }
    return most;
  };
  CHECK(uneven(FixedStep<>{}, 24) < 1e-10);
  CHECK_THAT(uneven(FixedStep<float>{}, 1), WithinAbs(179e-6, 1e-6));
  CHECK_THAT(uneven(FixedStep<float>{}, 24), WithinAbs(3.0 / 128 - 1.0 / 60, 1e-9));
}

TEST_CASE("In slow motion a jump is as high, and a new step size would throw the time back") {
  const auto top = [](double pace) {
    FixedStep<> clock;
    double height = 0, speed = 5, highest = 0;
    while (clock.steps < 60) {
      clock.frame(pace / 60, [&](double) {
        speed = speed - 9.81 * clock.h;
        height = height + speed * clock.h;
        highest = std::max(highest, height);
      });
    }
    return highest;
  };
  CHECK(top(0.25) == top(1));
  CHECK(top(0.1) == top(1));
  FixedStep<> clock{.steps = 600};
  double began = 0;
  const auto look = [&](double t) { began = t; };
  clock.h = 1 / 120.0;
  clock.frame(clock.h, look);
  CHECK(began == 5);
}
