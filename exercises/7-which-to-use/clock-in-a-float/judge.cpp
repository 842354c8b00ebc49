// SPDX-License-Identifier: MIT-0
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "clocks.h"
#include "format_values.h"
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

std::vector<std::string> recognise(double got, int rate, int ticks) {
  const std::string says = clocks::recognise(got, rate, ticks);
  return says.empty() ? std::vector<std::string>{} : std::vector{says};
}

// @param most  how far off the clock may be after a night, given the time [s]
template <class Most>
void shows_the_night(Student& student, Random& random, Most most, const std::string& hint) {
  for (const int rate : {72, 120}) {
    const int ticks = random.whole(6 * hour, 10 * hour) * rate + random.whole(1, rate - 1);
    const double expected = static_cast<double>(ticks) / rate;
    const double got = student.call(0, {double(rate), double(ticks), 0}, 2)[0];
    grade::Finding finding = off_by(std::abs(got - expected), most(expected), " s");
    finding.asked = "the time after a night [s]";
    finding.input = described(rate, ticks);
    finding.expected = number(expected, 16);
    finding.got = number(got, 16);
    if (!finding.held) {
      finding.error += got < expected ? " behind" : " ahead";
      finding.hint = hint;
      finding.diagnoses = recognise(got, rate, ticks);
    }
    check(finding);
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
          "[7-which-to-use/clock-in-a-float][3 points]") {
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
    finding.diagnoses = recognise(said.front(), rate, ticks);
    if (got == 0) finding.diagnoses.emplace_back("the clock stands still");
  }
  check(finding);
}

TEST_CASE("it strikes at each whole second, and never in between",
          "[7-which-to-use/clock-in-a-float][2 points]") {
  Student student;
  Random random;
  const int rate = rates.at(static_cast<std::size_t>(random.whole(0, 2)));
  is_silent_at_first(student, rate);
  const int ticks = random.whole(hour, 3 * hour) * rate;
  constexpr int seconds = 600;
  const std::vector<double> said =
      student.call(0, {double(rate), double(ticks), seconds}, 2 + 2 * seconds);
  std::size_t n = 0, late = 0;
  const auto strokes = [&](std::size_t second) { return static_cast<int>(said[1 + 2 * second]); };
  const auto last = [&](std::size_t second) { return static_cast<int>(said[2 + 2 * second]); };
  while (n + 1 < seconds && strokes(n) == 1 && last(n) == rate) ++n;
  for (std::size_t second = 0; second < seconds; ++second) late += last(second) == 1;

  grade::Finding finding;
  finding.held = strokes(n) == 1 && last(n) == rate;
  finding.asked = "when it strikes in second " + std::to_string(n + 1) +
                  " of ten minutes; the tick that completes the second is its tick " +
                  std::to_string(rate);
  finding.input = described(rate, ticks) + ", and then the ten minutes";
  finding.expected = "a stroke at tick " + std::to_string(rate) + " of " + std::to_string(rate);
  finding.got = heard(strokes(n), last(n), rate);
  finding.error = late_or_early(strokes(n), last(n), rate);
  finding.tolerance = "none";
  finding.tolerance_from = "strokes and ticks are counted";
  if (!finding.held) {
    finding.hint =
        "A time that should be a whole second may be a rounding below it. Which number of the "
        "clock is whole without rounding?";
    finding.diagnoses = recognise(said.front(), rate, ticks);
    if (late == seconds) finding.diagnoses.emplace_back("every stroke comes one tick late");
  }
  check(finding);
}
