// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "format_values.h"
#include "harness.h"
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
  const std::vector<double> answer = student.call(0, arguments, 3 * frames.size());
  std::vector<After> shown;
  double steps = 0;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    steps += answer[3 * n];
    shown.push_back({steps, answer[3 * n + 1], answer[3 * n + 2]});
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

// What is looked at beside the steps: what they leave, what of it is seen, or both.
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

void keeps_time(Student& student, double h, const std::vector<Frame>& frames, Judged judged,
                const std::string& which, const std::string& hint, const char* before = nullptr) {
  const std::vector<After> got = show(student, h, frames);
  const std::vector<double> time = times(frames);
  const Tolerance within = tolerance(h, frames, time.back());
  const std::size_t bad = first_wrong(got, time, h, within.value, judged);
  const std::size_t n = std::min(bad, frames.size() - 1);

  grade::Finding finding;
  finding.held = bad == frames.size();
  const std::string rest = judged == saved     ? "what is saved"
                           : judged == blended ? "the blend"
                                               : "the blend, or what is saved,";
  finding.asked = std::to_string(frames.size()) + " frames " + which + ": after each, steps and " +
                  rest + " add up to the game time, and " + rest + " is under one step";
  finding.input = "h = " + number(h, 17) + ", frames of";
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
    keeps_time(student, h, frames, saved,
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
  keeps_time(student, h, equal(300, h / random.between(2.1, 4.9)), blended,
             "that are shorter than a step",
             "Most frames have no step. What moves the picture in those?");
}

TEST_CASE("on a slow screen several steps are due in a frame, and the rest is kept",
          "[1-test-case/leftover-time][2 points]") {
  Student student;
  Random random;
  const double h = 1 / random.between(200, 400);
  keeps_time(student, h, equal(300, h * (random.whole(2, 6) + random.between(0.2, 0.8))), all,
             "that are longer than a step",
             "How often must the loop go round, and what is left when it ends?");
  // Powers of two add up without rounding.
  const double binary = std::ldexp(1.0, -random.whole(6, 8));
  keeps_time(student, binary, equal(20, binary * random.whole(2, 5)), all,
             "that last just so many steps",
             "Time for just one step more is there, and nothing is left over then. Is it due?");
  for (const double step : harness_bounds::h.asked())
    keeps_time(student, step,
               {{harness_bounds::length.largest()},
                {0.3 * step},
                {harness_bounds::length.smallest()},
                {harness_bounds::length.largest() - 0.1 * step}},
               all, "of which one is a long hitch, and another takes no time at all",
               "A step may be long or short, and a frame, too: the same sums hold.");
}

TEST_CASE("in slow motion the steps come more rarely, and a change of pace shows no jump",
          "[1-test-case/leftover-time][3 points]") {
  Student student;
  Random random;
  // Drawn one after the other: in which order arguments are computed is the compiler's choice.
  const auto frames = of_many_paces(random);
  const double h = 1 / random.between(40, 80);
  keeps_time(student, h, frames, blended, "whose pace changes now and then",
             "Let what is saved be game time, and ask what a frame adds to it.");
}
