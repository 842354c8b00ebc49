// SPDX-License-Identifier: MIT-0
#include "course/late.h"

#include <catch2/catch_test_macros.hpp>

using namespace grade;
using namespace std::chrono_literals;

namespace {

const TimeZone berlin("Europe/Berlin");

Instant at(const std::string& text) {
  return berlin.latest(time_from(text).value().local);
}

const Instant end = at("2027-02-08T23:59:00");
const std::optional<LateRule> rule = LateRule{15min, 2, 3};

int taken_after(std::chrono::seconds late, int score, const std::optional<LateRule>& by = rule) {
  return taken(lateness(end + late, end, by, berlin), by, score);
}

}  // namespace

TEST_CASE("what comes by the end, or within the grace, is in time") {
  for (const auto late : {-1000h, 0h}) CHECK(lateness(end + late, end, rule, berlin).days == 0);
  CHECK(lateness(end + 15min, end, rule, berlin).days == 0);
  CHECK(lateness(end + 15min, end, rule, berlin).by == 0s);
  CHECK(lateness(end + 15min + 1s, end, rule, berlin).days == 1);
  CHECK(lateness(end + 1s, end, LateRule{}, berlin).days == 1);
}

TEST_CASE("each day begun takes its points, until nothing counts") {
  CHECK(taken_after(15min, 10) == 0);
  CHECK(taken_after(16min, 10) == 2);
  CHECK(taken_after(24h, 10) == 2);
  CHECK(taken_after(24h + 1s, 10) == 4);
  CHECK(taken_after(72h, 10) == 6);
  CHECK(taken_after(72h + 1s, 10) == 10);
  CHECK(!lateness(end + 72h + 1s, end, rule, berlin).counts);
  CHECK(lateness(end + 72h, end, rule, berlin).counts);
}

TEST_CASE("no more is taken than was earned") {
  CHECK(taken_after(48h, 3) == 3);
  CHECK(taken_after(48h, 0) == 0);
  CHECK(taken_after(24h * 365 * 500, 10, LateRule{0min, 1000, {}}) == 10);
}

TEST_CASE("with no days it always counts, and with none of them nothing late does") {
  CHECK(taken_after(24h * 400, 10, LateRule{0min, 0, {}}) == 0);
  CHECK(taken_after(1s, 10, LateRule{0min, 0, 0}) == 10);
}

TEST_CASE("without a rule what is late counts in full, and is late all the same") {
  CHECK(taken_after(1s, 10, std::nullopt) == 0);
  CHECK(lateness(end + 1s, end, std::nullopt, berlin).days == 1);
  CHECK(lateness(end + 24h * 400, end, std::nullopt, berlin).days == 400);
  CHECK(lateness(end + 24h * 400, end, std::nullopt, berlin).counts);
}

TEST_CASE("a day goes from what the clocks show to the same again, also where they are changed") {
  const Instant spring = at("2027-03-27T23:59:00"), autumn = at("2027-10-30T23:59:00");
  CHECK(lateness(spring + 23h, spring, rule, berlin).days == 1);
  CHECK(lateness(spring + 23h + 1s, spring, rule, berlin).days == 2);
  CHECK(lateness(autumn + 25h, autumn, rule, berlin).days == 1);
  CHECK(lateness(autumn + 25h + 1s, autumn, rule, berlin).days == 2);
  CHECK(lateness(autumn + 25h + 24h * 30, autumn, rule, berlin).days == 31);
}

TEST_CASE("a file that says that it is of another century is late by as many days") {
  CHECK(lateness(at("2106-02-07T00:00:00"), end, rule, berlin).days == 28853);
}

TEST_CASE("a student is told by how much it was late, and what that took") {
  const auto words = [](std::chrono::seconds late, const std::optional<LateRule>& by) {
    const Lateness found = lateness(end + late, end, by, berlin);
    return late_words(found, taken(found, by, 10));
  };
  CHECK(words(5min, rule).empty());
  CHECK(words(30h, rule) ==
        "Handed in 1 day 6 h after the end: 4 points are taken, for 2 days begun.");
  CHECK(words(1h, LateRule{0min, 1, {}}) ==
        "Handed in 1 h after the end: 1 point is taken, for 1 day begun.");
  CHECK(words(80h, rule) == "Handed in 3 days 8 h after the end, when nothing counted any more.");
  CHECK(words(1h, std::nullopt) == "Handed in 1 h after the end; that takes nothing.");
}
