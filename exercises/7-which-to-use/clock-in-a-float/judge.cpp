// SPDX-License-Identifier: MIT-0
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "format_values.h"
#include "harness/bounds.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"

using namespace judge;
using grade::number;

namespace {

constexpr int hour = 3600, minute = 60;

// Rates of screens and servers. At each of these a sum of doubles strikes late within an hour,
// which at some others it happens not to do.
constexpr std::array rates{72, 90, 120};

std::string described(int rate, int ticks) {
  return std::to_string(rate) + " ticks a second, " + std::to_string(ticks) + " ticks, that is " +
         number(ticks / 3600.0 / rate, 4) + " hours";
}

Tolerance division(double seconds) {
  return {
      4 * std::numeric_limits<double>::epsilon() * seconds,
      "a count, divided once or multiplied once by a quotient: three roundings at most, of half a "
      "unit in the sixteenth digit"};
}

// @param most  how far off the clock may be, given the time [s]
template <class Most>
void shows_the_time(Student& student, int rate, int ticks, Most most, const std::string& hint) {
  const double expected = static_cast<double>(ticks) / rate;
  const double got = student.call(0, {double(rate), double(ticks), 0}, 2)[0];
  grade::Finding finding = off_by(std::abs(got - expected), most(expected), " s");
  finding.asked = "the time after so many ticks [s]";
  finding.input = described(rate, ticks);
  finding.expected = number(expected, 16);
  finding.got = number(got, 16);
  if (!finding.held) {
    finding.error += got < expected ? " behind" : " ahead";
    finding.hint = hint;
  }
  check(finding);
}

template <class Most>
void shows_the_night(Student& student, Random& random, Most most, const std::string& hint) {
  for (const int rate : {72, 120}) {
    const int ticks = random.whole(6 * hour, 10 * hour) * rate + random.whole(1, rate - 1);
    shows_the_time(student, rate, ticks, most, hint);
  }
}

std::string heard(int strokes, int last, int rate) {
  if (strokes == 0) return "no stroke";
  const std::string at = "at tick " + std::to_string(last) + " of " + std::to_string(rate);
  if (strokes > 1) return std::to_string(strokes) + " strokes, the last " + at;
  return "a stroke " + at;
}

std::string late_or_early(int strokes, int last, int rate) {
  if (strokes != 1) return "strokes: " + std::to_string(strokes) + " instead of 1";
  if (last == rate) return "";
  const bool late = last <= rate / 2;
  const int ticks = late ? last : rate - last;
  return std::to_string(ticks) + (ticks == 1 ? " tick " : " ticks ") +
         (late ? "late: this is the stroke of the second before" : "early");
}

void is_silent_at_first(Student& student, int rate) {
  const bool strikes = student.call(1, {double(rate)}, 1)[0] != 0;
  grade::Finding finding;
  finding.held = !strikes;
  finding.asked = "whether a clock strikes that has not ticked yet";
  finding.input = std::to_string(rate) + " ticks a second";
  finding.expected = "no stroke";
  finding.got = strikes ? "a stroke" : "no stroke";
  finding.error = "a stroke";
  if (strikes) {
    finding.hint = "Which second would it be for?";
    finding.diagnoses = {
        "a stroke is for a second that went by, and none has gone by before the first tick"};
  }
  check(finding);
}

// A whole number of seconds has gone by when it begins to listen.
void strikes_each_second(Student& student, int rate, int ticks, int seconds) {
  const std::size_t count = static_cast<std::size_t>(seconds);
  const std::vector<double> said =
      student.call(0, {double(rate), double(ticks), double(seconds)}, 2 + 2 * count);
  std::size_t n = 0, late = 0;
  const auto strokes = [&](std::size_t second) { return static_cast<int>(said[1 + 2 * second]); };
  const auto last = [&](std::size_t second) { return static_cast<int>(said[2 + 2 * second]); };
  while (n + 1 < count && strokes(n) == 1 && last(n) == rate) ++n;
  for (std::size_t second = 0; second < count; ++second) late += last(second) == 1;

  grade::Finding finding;
  finding.held = strokes(n) == 1 && last(n) == rate;
  finding.asked = "when it strikes in second " + std::to_string(n + 1) + " of " +
                  std::to_string(seconds) + "; the tick that completes the second is its tick " +
                  std::to_string(rate);
  finding.input = described(rate, ticks) + ", and then so many seconds";
  finding.expected = "a stroke at tick " + std::to_string(rate) + " of " + std::to_string(rate);
  finding.got = heard(strokes(n), last(n), rate);
  finding.error = late_or_early(strokes(n), last(n), rate);
  finding.tolerance = "none";
  finding.tolerance_from = "strokes and ticks are counted";
  if (!finding.held) {
    finding.hint =
        "A time that should be a whole second may be a rounding below it. Which number of the "
        "clock is whole without rounding?";
    if (late == count) finding.diagnoses.emplace_back("every stroke comes one tick late");
  }
  check(finding);
}

}  // namespace

TEST_CASE("after a night the clock is right to a millisecond",
          "[7-which-to-use/clock-in-a-float][3 points]") {
  Student student;
  Random random;
  const auto millisecond = [](double) { return Tolerance{0.001, "the task"}; };
  shows_the_night(student, random, millisecond,
                  "How many digits does the time have by then, and how many does a float keep?");
}

TEST_CASE("after a night the clock is right to the last digit of a double",
          "[7-which-to-use/clock-in-a-float][2 points]") {
  Student student;
  Random random;
  shows_the_night(student, random, division,
                  "A tick that is no binary fraction is wrong from the start, and each sum rounds. "
                  "Ticks can be counted.");
}

TEST_CASE("after days a minute is as long as the first one",
          "[7-which-to-use/clock-in-a-float][2 points]") {
  Student student;
  Random random;
  const int rate = rates.at(static_cast<std::size_t>(random.whole(0, 2)));
  const int ticks = random.whole(84 * hour, 96 * hour) * rate;
  const std::vector<double> said =
      student.call(0, {double(rate), double(ticks), double(minute)}, 2 + 2 * minute);
  const double got = said.back() - said.front();
  grade::Finding finding =
      off_by(std::abs(got - minute), division(2 * ticks / double(rate) + minute), " s");
  finding.asked = "how long the next minute takes, by the clock [s]";
  finding.input = described(rate, ticks);
  finding.expected = "60";
  finding.got = number(got, 16);
  if (!finding.held) {
    finding.error += got < minute ? " too short" : " too long";
    finding.hint =
        "Is there a number in the clock that has grown so large that a tick no longer shows in it?";
    if (got == 0) finding.diagnoses.emplace_back("the clock stands still");
  }
  check(finding);
}

TEST_CASE("the clock strikes at each whole second, and never in between",
          "[7-which-to-use/clock-in-a-float][2 points]") {
  Student student;
  Random random;
  const int rate = rates.at(static_cast<std::size_t>(random.whole(0, 2)));
  is_silent_at_first(student, rate);
  strikes_each_second(student, rate, random.whole(hour, 3 * hour) * rate, 600);
}

TEST_CASE("at any rate the clock is right to the last digit, and strikes with the right tick",
          "[7-which-to-use/clock-in-a-float][1 point]") {
  constexpr harness::Bounds any_rate{"rate", 1, 1000, 2, 24, 60, 64};
  constexpr int clocks = 60;
  Student student;
  Random random;
  for (int n = 0; n < clocks; ++n) {
    const int rate = static_cast<int>(random.anywhere(any_rate)), seconds = random.whole(0, 200);
    is_silent_at_first(student, rate);
    shows_the_time(
        student, rate, seconds * rate + random.whole(0, rate - 1), division,
        "Is anything in the clock fixed for one rate, or kept from one clock to another?");
    strikes_each_second(student, rate, seconds * rate, 3);
  }
}
