// SPDX-License-Identifier: MIT-0
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "format_values.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"

using namespace judge;
using grade::number;

namespace {

// Rates of screens and servers; none of them a power of two, whose ticks even a float adds up.
int draw_rate(Random& random, std::size_t first) {
  constexpr std::array rates{30, 50, 60, 72, 90, 120};
  return rates.at(first + static_cast<std::size_t>(random.whole(0, 5 - static_cast<int>(first))));
}

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

}  // namespace

TEST_CASE("after a night the clock shows the night",
          "[7-which-to-use/clock-in-a-float][4 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 2; ++n) {
    const int rate = draw_rate(random, 0);
    const int ticks = random.whole(6 * 3600, 10 * 3600) * rate + random.whole(1, rate - 1);
    const double expected = static_cast<double>(ticks) / rate;
    is_exact(
        "the time after a night [s]", described(rate, ticks),
        student.call(0, {double(rate), double(ticks), 0}, 2)[0], expected, division(expected),
        "Each sum rounds, and a tick that is no binary fraction is wrong from the start. Ticks "
        "can be counted.");
  }
}

TEST_CASE("after days a minute is as long as the first one",
          "[7-which-to-use/clock-in-a-float][3 points]") {
  Student student;
  Random random;
  const int rate = draw_rate(random, 2);
  constexpr int hour = 3600, minute = 60;
  const int ticks = random.whole(84 * hour, 96 * hour) * rate;
  const std::vector<double> said =
      student.call(0, {double(rate), double(ticks), double(minute)}, 2 + 2 * minute);
  is_exact(
      "how long the next minute takes, by the clock [s]", described(rate, ticks),
      said.back() - said.front(), minute, division(2 * said.front() + minute),
      "Is there a number in the clock that has grown so large that a tick no longer shows in it?");
}

TEST_CASE("it strikes at each whole second, and never in between",
          "[7-which-to-use/clock-in-a-float][3 points]") {
  Student student;
  Random random;
  const int rate = draw_rate(random, 0);
  const int ticks = random.whole(3600, 3 * 3600) * rate;
  constexpr int seconds = 600;
  const std::vector<double> said =
      student.call(0, {double(rate), double(ticks), seconds}, 2 + 2 * seconds);
  for (std::size_t n = 0; n < seconds; ++n) {
    const double strokes = said[1 + 2 * n], last = said[2 + 2 * n];
    grade::Finding finding;
    finding.held = strokes == 1 && last == rate;
    finding.asked =
        "when it strikes in second " + std::to_string(n + 1) + " of the next ten minutes";
    finding.input = described(rate, ticks);
    finding.expected = "once, at tick " + std::to_string(rate) + " of it";
    finding.got =
        number(strokes) + " times" + (strokes > 0 ? ", last at tick " + number(last) : "");
    finding.error = number(strokes - 1) + " strokes, " + number(last - rate) + " ticks";
    finding.tolerance = "none";
    finding.tolerance_from = "both are counted";
    if (!finding.held) {
      finding.hint =
          "A time that should be a whole second may be a rounding below it. Which number of "
          "the clock is whole without rounding?";
      return check(finding);
    }
    if (n + 1 == seconds) check(finding);
  }
}
