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

TEMPLATE_TEST_CASE("Every step starts where the one before ended", "", FixedStep<>,
                   FixedStep<float>, (FixedStep<float, float>)) {
  TestType clock{.h = 0.25f};
  using Time = decltype(clock.saved);
  using Real = decltype(clock.h);
  std::vector<Time> starts;
  for (const double frame : {0.125, 0.125, 0.0625, 0.1875, 0.25, 0.2}) {
    clock.frame(Time(frame), [&](auto t) {
      STATIC_CHECK(std::is_same_v<decltype(t), Time>);
      starts.push_back(t);
    });
  }
  CHECK(starts == std::vector<Time>{0, Time(0.25), Time(0.5)});
  CHECK(clock.steps == 3);
  CHECK(clock.time() == Time(0.75));
  CHECK_THAT(clock.saved, WithinAbs(Time(0.2), Time(1e-6)));
  STATIC_CHECK(std::is_same_v<decltype(clock.blend()), Real>);
  CHECK_THAT(clock.blend(), WithinRel(Real(0.8), Real(1e-6)));
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
                   FixedStep<>, FixedStep<float>, (FixedStep<float, float>)) {
  TestType clock{.h = 0.125f, .saved = 0.0625f};
  using Time = decltype(clock.saved);
  using Limits = std::numeric_limits<Time>;
  int steps = 0;
  const auto count = [&](Time) { ++steps; };
  for (const Time length : {Limits::quiet_NaN(), -Limits::quiet_NaN(), -Limits::infinity()}) {
    clock.frame(length, count);
    CHECK(steps == 0);
    CHECK(clock.saved == Time(0.0625));
  }
  clock.frame(Time(0.125), count);
  CHECK(steps == 1);
  CHECK(clock.blend() == decltype(clock.h)(0.5));
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
  const auto uneven = [](auto clock, long long hours) {
    clock.steps = 60LL * 3600 * hours;
    double before = 0, most = 0;
    for (int n = 0; n < 600; ++n) {
      clock.frame(clock.h, [&](auto t) {
        if (before > 0) most = std::max(most, std::abs(double(t) - before - double(clock.h)));
        before = double(t);
      });
    }
    return most;
  };
  using Floats = FixedStep<float, float>;
  CHECK(uneven(FixedStep<>{}, 24) < 1e-10);
  CHECK(uneven(FixedStep<float>{}, 24) < 1e-10);
  CHECK_THAT(uneven(Floats{}, 1), WithinAbs(179e-6, 1e-6));
  CHECK_THAT(uneven(Floats{}, 24), WithinAbs(3.0 / 128 - double(1 / 60.0f), 1e-9));
}

// As a game stalls: a late frame in fifty, and every few seconds a hitch of a fifth of a second.
double frame_with_hitches(frames::Playback& recorded, int n) {
  return n % 250 == 249 ? 0.15 + 0.05 * (n % 3) / 2 : recorded.next();
}

TEST_CASE("Beside floats a clock takes as many steps, through hitches, too") {
  frames::Playback recorded;
  FixedStep<> doubles{.h = 1 / 60.0};
  FixedStep<float> floats{.h = 1 / 60.0f};
  double total = 0;
  for (int n = 0; n < 2000; ++n) {
    const double length = frame_with_hitches(recorded, n);
    total += length;
    doubles.frame(length, [](double) {});
    floats.frame(length, [](double) {});
    REQUIRE(std::abs(doubles.steps - floats.steps) <= 1);
  }
  CHECK(doubles.steps == (long long)(total * 60));
  CHECK_THAT(doubles.time() + doubles.saved, WithinRel(total, 1e-13));
  CHECK_THAT(floats.time() + floats.saved, WithinRel(total, 1e-13));
}

TEST_CASE("In slow motion a jump is as high, and in a pause nothing moves") {
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
  FixedStep<> clock{.saved = 0.01, .steps = 3};
  const double shown = clock.blend();
  for (int n = 0; n < 600; ++n) clock.frame(0.0 / 60, [](double) { FAIL("a step"); });
  CHECK(clock.blend() == shown);
  CHECK(clock.time() == 0.05);
}

TEMPLATE_TEST_CASE("Another step size leaves the time and the count as they are", "", FixedStep<>,
                   FixedStep<float>, (FixedStep<float, float>)) {
  using Time = decltype(TestType::saved);
  TestType clock{.h = 1 / 64.0f, .saved = 3 / 256.0f, .steps = 640};
  std::vector<Time> starts;
  const auto note = [&](Time t) { starts.push_back(t); };
  clock.change_step(1 / 128.0f);
  CHECK(clock.time() == 10);
  CHECK(clock.steps == 640);
  CHECK(clock.blend() == 1);
  clock.frame(Time(1) / 128, note);
  CHECK(starts == std::vector<Time>{10, 10 + Time(1) / 128});
  CHECK(clock.saved == Time(1) / 256);
  clock.change_step(1 / 32.0f);
  clock.frame(Time(3) / 64, note);
  CHECK(starts.back() == 10 + Time(1) / 64);
  CHECK(clock.steps == 643);
  CHECK(clock.time() == 10 + Time(3) / 64);
  CHECK(clock.saved == Time(5) / 256);
  CHECK(clock.blend() == 0.625f);
}

TEST_CASE("In a pause no step is taken, whatever was saved") {
  FixedStep<> clock{.h = 0.125, .saved = 0.0625};
  clock.change_step(0.03125);
  for (const double length : {0.0, -0.0, -1.0}) clock.frame(length, [](double) { FAIL("a step"); });
  CHECK(clock.saved == 0.0625);
  CHECK(clock.blend() == 1);
  clock.frame(0.03125, [](double) {});
  CHECK(clock.steps == 3);
}

TEST_CASE("A step may ask for another size of those behind it") {
  FixedStep<> clock{.h = 1 / 16.0};
  std::vector<double> starts;
  clock.frame(0.25, [&](double t) {
    starts.push_back(t);
    clock.change_step(1 / 32.0);
  });
  const std::vector<double> wanted{0, 2 / 32.0, 3 / 32.0, 4 / 32.0, 5 / 32.0, 6 / 32.0, 7 / 32.0};
  CHECK(starts == wanted);
  CHECK(clock.time() + clock.saved == 0.25);
}

TEST_CASE("A step size that is not above zero changes nothing") {
  FixedStep<> clock{.h = 0.125, .steps = 8};
  for (const double size : {0.0, -0.0, -0.25, std::numeric_limits<double>::quiet_NaN()}) {
    clock.change_step(size);
    CHECK(clock.h == 0.125);
    CHECK(clock.time() == 1);
  }
}

TEST_CASE("Step sizes that change all the time lose none of it") {
  frames::Playback recorded;
  FixedStep<> clock{.longest_frame = 1};
  double total = 0;
  for (int n = 0; n < 100'000; ++n) {
    const double length = frame_with_hitches(recorded, n);
    total += length;
    clock.change_step(1 / (20.0 + n % 101));
    clock.frame(length, [](double) {});
    REQUIRE(clock.saved < clock.h);
  }
  CHECK_THAT(clock.time() + clock.saved, WithinRel(total, 1e-12));
}
