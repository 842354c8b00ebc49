// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "format_values.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "screen.h"

using namespace judge;
using namespace judge::leftover_time;

namespace {

using grade::number;

std::vector<After> show(Student& student, double h, const std::vector<Frame>& frames) {
  std::vector<double> arguments{h, static_cast<double>(frames.size())};
  for (const Frame& frame : frames) arguments.insert(arguments.end(), {frame.length, frame.pace});
  const std::vector<double> answer = student.call(0, arguments, 2 * frames.size());
  std::vector<After> shown;
  double steps = 0;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    steps += answer[2 * n];
    shown.push_back({steps, answer[2 * n + 1]});
  }
  return shown;
}

// Of the game, after each frame [s].
std::vector<double> times(const std::vector<Frame>& frames) {
  std::vector<double> sums;
  double time = 0;
  for (const Frame& frame : frames) sums.push_back(time += frame.pace * frame.length);
  return sums;
}

// Yours: a sum a frame and one a step, of numbers up to the longest frame. Ours: a sum a frame, of
// numbers up to the whole time.
Tolerance tolerance(double h, const std::vector<Frame>& frames, double whole) {
  const auto binary = [](double value) { return value == std::ldexp(1.0, std::ilogb(value)); };
  if (binary(h) && std::ranges::all_of(frames, [&](const Frame& frame) {
        return frame.pace == 1 && std::fmod(frame.length, h) == 0;
      }))
    return {0, "frames of whole steps, whose length is a power of two: nothing is rounded"};
  double longest = 1;
  for (const Frame& frame : frames) longest = std::max(longest, frame.pace * frame.length / h + 1);
  const double each = (longest + 4) * longest + whole / h;
  return {static_cast<double>(frames.size()) * each * std::numeric_limits<double>::epsilon(),
          "rounding: one sum a frame and one a step, each wrong by at most half a unit in the "
          "sixteenth digit, in your clock and in the judge's"};
}

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

// The first frame after which the picture is not where the time is; all of them if none.
std::size_t first_wrong(const std::vector<After>& got, const std::vector<double>& time, double h,
                        double within) {
  for (std::size_t n = 0; n < got.size(); ++n) {
    const double off = std::abs(got[n].picture() - time[n] / h), blend = got[n].blend;
    if (!(off <= within && blend >= -within && blend < 1 + within)) return n;
  }
  return got.size();
}

void keeps_time(Student& student, double h, const std::vector<Frame>& frames,
                const std::string& which, const std::string& hint, const char* before = nullptr) {
  const std::vector<After> got = show(student, h, frames);
  const std::vector<double> time = times(frames);
  const Tolerance within = tolerance(h, frames, time.back());
  const std::size_t bad = first_wrong(got, time, h, within.value);
  const std::size_t n = std::min(bad, frames.size() - 1);

  grade::Finding finding;
  finding.held = bad == frames.size();
  finding.asked = std::to_string(frames.size()) + " frames " + which +
                  ": after each, steps and blend add up to the game time, and the blend is under 1";
  finding.input = "h = " + number(h, 17) + ", frames of";
  constexpr std::size_t most = 6;
  for (std::size_t i = 0; i < std::min(n + 1, most); ++i) {
    finding.input += " " + described(frames[i]);
  }
  finding.input += " s";
  if (n >= most)
    finding.input +=
        " and so on; frame " + std::to_string(n + 1) + " of " + described(frames[n]) + " s";
  finding.expected = "after frame " + std::to_string(n + 1) + ": " +
                     number(std::floor(time[n] / h)) + " steps and a blend of " +
                     number(time[n] / h - std::floor(time[n] / h));
  finding.got = number(got[n].steps) + " steps and a blend of " + number(got[n].blend);
  finding.error = number(std::abs(got[n].picture() - time[n] / h), 3) + " steps";
  if (got[n].blend < 0 || got[n].blend >= 1) finding.error += ", and the blend is not from 0 to 1";
  finding.tolerance = number(within.value, 2);
  finding.tolerance_from = within.from;
  if (!finding.held) {
    finding.diagnoses = recognise(got, frames, time, h);
    if (before) finding.diagnoses.emplace_back(before);
    if (finding.diagnoses.empty()) finding.hint = hint;
    finding.plot = plot(got, time, h);
  }
  check(finding);
}

std::vector<Frame> equal(int count, double length) {
  return std::vector<Frame>(static_cast<std::size_t>(count), {length});
}

// A while at the usual pace, then slowly, then a pause, then fast, and slowly again.
std::vector<Frame> of_many_paces(Random& random) {
  std::vector<Frame> frames;
  for (const double pace :
       {1.0, random.between(0.1, 0.4), 0.0, random.between(1.5, 3), random.between(0.1, 0.4)}) {
    for (int n = 0; n < 60; ++n) frames.push_back({random.between(0.004, 0.02), pace});
  }
  return frames;
}

}  // namespace

TEST_CASE("uneven frames are paid with as many steps as fit into them",
          "[1-test-case/leftover-time][3 points]") {
  Student student;
  Random random;
  const std::string hint =
      "What a frame leaves over belongs to the next one. By how much does a step lessen it?";
  for (const bool again : {false, true}) {
    const double h = 1 / random.between(90, 250);
    std::vector<Frame> frames;
    for (int n = 1; n <= 600; ++n) {
      frames.push_back(
          {n % 60 == 0 ? random.between(2 * hitch, 6 * hitch) : random.between(0.008, 0.04)});
    }
    keeps_time(student, h, frames,
               again ? "of a second level" : "of many lengths, with a hitch in every sixtieth",
               hint,
               again ? "the first level was right: something is remembered from it" : nullptr);
  }
}

TEST_CASE("on a fast screen the picture moves by the same amount in every frame",
          "[1-test-case/leftover-time][2 points]") {
  Student student;
  Random random;
  const double h = 1 / random.between(40, 80);
  keeps_time(student, h, equal(300, h / random.between(2.1, 4.9)), "that are shorter than a step",
             "Most frames have no step. What moves the picture in those?");
}

TEST_CASE("on a slow screen several steps are due in a frame, and the rest is kept",
          "[1-test-case/leftover-time][2 points]") {
  Student student;
  Random random;
  const double h = 1 / random.between(200, 400);
  keeps_time(student, h, equal(300, h * (random.whole(2, 6) + random.between(0.2, 0.8))),
             "that are longer than a step",
             "How often must the loop go round, and what is left when it ends?");
  // Powers of two add up without rounding.
  const double binary = std::ldexp(1.0, -random.whole(6, 8));
  keeps_time(student, binary, equal(20, binary * random.whole(2, 5)),
             "that last just so many steps",
             "Time for just one step more is there, and nothing is left over then. Is it due?");
}

TEST_CASE("in slow motion the steps come more rarely, and a change of pace shows no jump",
          "[1-test-case/leftover-time][3 points]") {
  Student student;
  Random random;
  // Drawn one after the other: in which order arguments are computed is the compiler's choice.
  const auto frames = of_many_paces(random);
  const double h = 1 / random.between(40, 80);
  keeps_time(student, h, frames, "whose pace changes now and then",
             "Let what is saved be game time, and ask what a frame adds to it.");
}
