// SPDX-License-Identifier: MIT-0
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "format_values.h"
#include "harness.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "scene.h"

using namespace judge;
using namespace judge::leftover_time;

namespace {

using grade::number;

std::vector<After> show(Student& student, const Level& level) {
  const std::vector<Frame>& frames = level.frames;
  std::vector<double> arguments{level.saved, level.h, static_cast<double>(frames.size())};
  for (const Frame& frame : frames) arguments.insert(arguments.end(), {frame.length, frame.pace});
  const std::vector<double> answer = student.call(0, arguments, 3 * frames.size());
  std::vector<After> shown;
  double steps = 0;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    steps += answer[3 * n];
    shown.push_back({steps, answer[3 * n + 1], answer[3 * n + 2]});
  }
  return shown;
}

// Clocks by turns in one program, a frame of each after a frame of the other.
std::array<std::vector<After>, 2> show(Student& student, const std::array<Level, 2>& levels) {
  std::array<std::vector<After>, 2> shown;
  for (std::size_t n = 0; n < levels[0].frames.size(); ++n) {
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const After before = n > 0 ? shown[i].back() : After{0, 0, levels[i].saved};
      const Level one{levels[i].h, {levels[i].frames[n]}, before.saved};
      After now = show(student, one)[0];
      now.steps += before.steps;
      shown[i].push_back(now);
    }
  }
  return shown;
}

// The time of the game, after each frame [s].
std::vector<double> times(const Level& level) {
  std::vector<double> sums;
  double time = level.saved;
  for (const Frame& frame : level.frames) sums.push_back(time += frame.pace * frame.length);
  return sums;
}

// Yours: a sum a frame and one a step, of numbers up to the frame. Ours: a sum a frame, of numbers
// up to the whole time.
Tolerance digits(const Level& level) {
  const auto binary = [](double value) { return value == std::ldexp(1.0, std::ilogb(value)); };
  if (binary(level.h) && level.saved == 0 &&
      std::ranges::all_of(level.frames, [&](const Frame& frame) {
        return frame.pace == 1 && std::fmod(frame.length, level.h) == 0;
      }))
    return {0, "frames of whole steps, whose length is a power of two: nothing is rounded"};
  double sums = 0;
  for (const Frame& frame : level.frames) {
    const double steps = frame.pace * frame.length / level.h + 1;
    sums += (steps + 4) * steps;
  }
  sums += static_cast<double>(level.frames.size()) * times(level).back() / level.h;
  return {sums * std::numeric_limits<double>::epsilon(),
          "rounding: one sum a frame and one a step, each wrong by at most half a unit in the "
          "sixteenth digit, in your clock and in the judge's"};
}

// A thousandth of a step; the digits are asked for where frames are uneven.
const Tolerance to_the_eye{1e-3, "nobody sees less of the way between two states"};

grade::Plot plot(const std::vector<After>& got, const std::vector<double>& time, double h) {
  grade::Curve yours{"yours", {}, {}}, right{"the time that has gone by", {}, {}};
  for (std::size_t n = 0; n < std::min<std::size_t>(got.size(), 40); ++n) {
    yours.x.push_back(time[n]);
    yours.y.push_back(got[n].picture());
    right.x.push_back(time[n]);
    right.y.push_back(time[n] / h);
  }
  return {"What the screen shows", "game time [s]", "steps and blend", {yours, right}};
}

// The part that is judged beside the steps: what they leave, what of it is seen, or both.
enum Judged { saved, blended, all };

// The first frame after which the clock is not where the time is; all of them if none.
std::size_t first_wrong(const std::vector<After>& got, const std::vector<double>& time, double h,
                        double within, Judged judged) {
  for (std::size_t n = 0; n < got.size(); ++n) {
    const auto is_rest = [&](double share) {
      return std::abs(got[n].steps + share - time[n] / h) <= within && share >= -within &&
             share < 1 + within;
    };
    if (judged != saved && !is_rest(got[n].blend)) return n;
    if (judged != blended && !is_rest(got[n].saved / h)) return n;
  }
  return got.size();
}

std::string described(const After& now, Judged judged) {
  std::string text = number(now.steps) + " steps";
  if (judged != saved) text += " and a blend of " + number(now.blend);
  if (judged != blended) text += " and " + number(now.saved) + " s saved";
  return text;
}

void keeps_time(const std::vector<After>& got, const Level& level, Judged judged,
                const Tolerance& within, const std::string& which, const std::string& hint,
                const std::string& before = "") {
  const std::vector<double> time = times(level);
  const std::vector<Frame>& frames = level.frames;
  const double h = level.h;
  const std::size_t bad = first_wrong(got, time, h, within.value, judged);
  const std::size_t n = std::min(bad, frames.size() - 1);

  grade::Finding finding;
  finding.held = bad == frames.size();
  const std::string rest = judged == saved     ? "what is saved"
                           : judged == blended ? "the blend"
                                               : "the blend, or what is saved,";
  finding.asked = std::to_string(frames.size()) + " frames " + which + ": after each, steps and " +
                  rest + " add up to the game time, and " + rest + " is under one step";
  finding.input = "h = " + number(h, 17);
  if (level.saved > 0) finding.input += ", " + number(level.saved, 17) + " s saved before";
  finding.input += ", frames of";
  constexpr std::size_t most = 6;
  for (std::size_t i = 0; i < std::min(n + 1, most); ++i) {
    finding.input += " " + described(frames[i]);
  }
  finding.input += " s";
  if (n >= most)
    finding.input +=
        " and so on; frame " + std::to_string(n + 1) + " of " + described(frames[n]) + " s";
  const double due = std::floor(time[n] / h), part = time[n] / h - due;
  finding.expected =
      "after frame " + std::to_string(n + 1) + ": " + described({due, part, part * h}, judged);
  finding.got = described(got[n], judged);
  const double left = judged == saved ? got[n].saved / h : got[n].blend;
  finding.error = number(std::abs(got[n].steps + left - time[n] / h), 3) + " steps";
  if (judged != saved && (left < 0 || left >= 1))
    finding.error += ", and the blend is not from 0 to 1";
  finding.tolerance = number(within.value, 2);
  finding.tolerance_from = within.from;
  if (!finding.held) {
    finding.diagnoses = what_is_wrong(got, level, time);
    if (!before.empty()) finding.diagnoses.push_back(before);
    if (finding.diagnoses.empty()) finding.hint = hint;
    finding.plot = plot(got, time, h);
  }
  check(finding);
}

std::vector<Frame> equal(int count, double length) {
  return std::vector<Frame>(static_cast<std::size_t>(count), {length});
}

// A clock of any step, with any time saved up to just under it, and a few frames of any length and
// pace.
Level any_level(Random& random) {
  Level level{random.anywhere(harness_bounds::h), {}, random.anywhere(harness_bounds::saved)};
  if (random.whole(0, 1) == 0) level.saved = level.h - level.saved;
  level.saved = std::clamp(level.saved, 0.0, std::nextafter(level.h, 0));
  constexpr int frames = 4;
  for (int n = 0; n < frames; ++n) {
    const double length = random.anywhere(harness_bounds::length);
    level.frames.push_back({length, random.anywhere(harness_bounds::pace)});
  }
  return level;
}

// Returns whether a clock alone, in a program that has just begun, shows the time.
bool right_when_fresh(const Level& level) {
  Student fresh;
  const std::vector<After> got = show(fresh, level);
  return first_wrong(got, times(level), level.h, digits(level).value, all) == got.size();
}

// A while at the usual pace, then slowly, then a pause, then fast, slowly again, and one frame as
// fast as may be.
std::vector<Frame> of_many_paces(Random& random) {
  std::vector<Frame> frames;
  for (const double pace : {1.0, random.between(0.1, 0.4), harness_bounds::pace.smallest(),
                            random.between(1.5, 3), random.between(0.1, 0.4)}) {
    for (int n = 0; n < 60; ++n) frames.push_back({random.between(0.004, 0.02), pace});
  }
  frames.push_back({random.between(0.004, 0.02), harness_bounds::pace.largest()});
  return frames;
}

}  // namespace

TEST_CASE("uneven frames are paid with as many steps as fit into them",
          "[1-test-case/leftover-time][2 points]") {
  Student student;
  Random random;
  const std::string hint =
      "What a frame leaves over belongs to the next one. By how much does a step lessen it?";
  for (const bool again : {false, true}) {
    Level level{1 / random.between(90, 250), {}};
    for (int n = 1; n <= 600; ++n) {
      level.frames.push_back(
          {n % 60 == 0 ? random.between(2 * hitch, 6 * hitch) : random.between(0.008, 0.04)});
    }
    keeps_time(show(student, level), level, saved, digits(level),
               again ? "of a second level" : "of many lengths, with a hitch in every sixtieth",
               hint, again ? "the first level was right: something is remembered from it" : "");
  }
}

TEST_CASE("on a fast screen the picture moves by the same amount in every frame",
          "[1-test-case/leftover-time][2 points]") {
  Student student;
  Random random;
  const double h = 1 / random.between(40, 80);
  const Level level{h, equal(300, h / random.between(2.1, 4.9))};
  keeps_time(show(student, level), level, blended, to_the_eye, "that are shorter than a step",
             "Most frames have no step. What moves the picture in those?");
}

TEST_CASE("on a slow screen several steps are due in a frame, and the rest is kept",
          "[1-test-case/leftover-time][2 points]") {
  Student student;
  Random random;
  const double h = 1 / random.between(200, 400);
  const Level longer{h, equal(300, h * (random.whole(2, 6) + random.between(0.2, 0.8)))};
  keeps_time(show(student, longer), longer, saved, to_the_eye, "that are longer than a step",
             "How often must the loop go round, and what is left when it ends?");
  // Powers of two add up without rounding.
  const double binary = std::ldexp(1.0, -random.whole(6, 8));
  const Level whole{binary, equal(20, binary * random.whole(2, 5))};
  keeps_time(show(student, whole), whole, saved, digits(whole), "that last just so many steps",
             "Time for just one step more is there, and nothing is left over then. Is it due?");
}

TEST_CASE("in slow motion the steps come more rarely, and a change of pace shows no jump",
          "[1-test-case/leftover-time][3 points]") {
  Student student;
  Random random;
  // Drawn one after the other: in which order arguments are computed is the compiler's choice.
  const auto frames = of_many_paces(random);
  const Level level{1 / random.between(40, 80), frames};
  keeps_time(show(student, level), level, blended, to_the_eye, "whose pace changes now and then",
             "Let what is saved be game time, and ask what a frame adds to it.");
}

TEST_CASE("two clocks by turns are right, with any steps, frames and paces",
          "[1-test-case/leftover-time][1 point]") {
  Student student;
  Random random;
  constexpr int pairs = 200;
  for (int n = 0; n < pairs; ++n) {
    std::array<Level, 2> levels{any_level(random), any_level(random)};
    // The most steps that a frame can ask for.
    if (n == 0)
      levels[0] = {harness_bounds::h.smallest(),
                   {levels[0].frames.size(),
                    {harness_bounds::length.largest(), harness_bounds::pace.largest()}}};
    const auto got = show(student, levels);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const Level& level = levels[i];
      const bool wrong =
          first_wrong(got[i], times(level), level.h, digits(level).value, all) < got[i].size();
      keeps_time(got[i], level, all, digits(level), "of a clock that takes turns with another",
                 "All sizes go by the same sums. Which of these numbers is so small, or so large, "
                 "that a line of yours does something of its own?",
                 wrong && right_when_fresh(level) ? "in a program that has just begun this clock "
                                                    "is right: what is remembered?"
                                                  : "");
    }
  }
}
