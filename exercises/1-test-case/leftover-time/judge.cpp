// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
#include <numeric>

#include "format_values.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"

using namespace judge;

namespace {

using grade::number;

// After a frame: all steps up to here, and how far the picture is towards the next.
struct After {
  double steps, blend;
  double picture() const { return steps + blend; }
};

std::vector<After> show(Student& student, double h, const std::vector<double>& frames) {
  std::vector<double> arguments{h, static_cast<double>(frames.size())};
  arguments.insert(arguments.end(), frames.begin(), frames.end());
  const std::vector<double> answer = student.call(0, arguments, 2 * frames.size());
  std::vector<After> shown;
  double steps = 0;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    steps += answer[2 * n];
    shown.push_back({steps, answer[2 * n + 1]});
  }
  return shown;
}

std::vector<double> times(const std::vector<double>& frames) {
  std::vector<double> sums(frames.size());
  std::partial_sum(frames.begin(), frames.end(), sums.begin());
  return sums;
}

// Yours: a sum a frame and one a step, of numbers up to the longest frame. Ours: a sum a frame, of
// numbers up to the whole time.
Tolerance tolerance(double h, const std::vector<double>& frames, double whole) {
  const double longest = *std::max_element(frames.begin(), frames.end()) / h + 1;
  const double each = (longest + 4) * longest + whole / h;
  return {static_cast<double>(frames.size()) * each * std::numeric_limits<double>::epsilon(),
          "rounding: one sum a frame and one a step, each wrong by at most half a unit in the "
          "sixteenth digit, in your clock and in the judge's"};
}

double most_in_a_frame(const std::vector<After>& got) {
  double most = got.front().steps;
  for (std::size_t n = 1; n < got.size(); ++n) {
    most = std::max(most, got[n].steps - got[n - 1].steps);
  }
  return most;
}

bool forgets_the_frame_before(const std::vector<After>& got, const std::vector<double>& time,
                              double h) {
  for (std::size_t n = 1; n < got.size(); ++n) {
    const double taken = got[n].steps - got[n - 1].steps;
    if (taken != std::floor((time[n] - time[n - 1]) / h)) return false;
  }
  return true;
}

std::vector<std::string> recognise(const std::vector<After>& got, const std::vector<double>& time,
                                   double h) {
  const double pace = got.back().picture() * h / time.back();
  const double a_frame = got.back().steps / static_cast<double>(got.size());
  std::vector<std::string> found;
  if (std::abs(pace - 1) > 0.01) {
    found.push_back("the game runs at " + number(pace, 3) + " times its speed");
  }
  if (std::abs(pace / 1000 - 1) < 0.01) found.push_back("milliseconds where seconds are meant?");
  if (std::abs(pace - 1) > 0.01 && std::abs(a_frame - 1) < 0.02) {
    found.push_back("about one step in every frame: the steps follow the frames");
  }
  const auto always = [&](auto is) { return std::all_of(got.begin(), got.end(), is); };
  if (always([](const After& now) { return now.blend == 0; })) {
    found.push_back("the blend is always 0: nothing is left over after a frame");
  }
  if (always([](const After& now) { return now.blend == 1; })) {
    found.push_back("the blend is always 1: this shows the newest state, not one between two");
  }
  if (std::any_of(got.begin(), got.end(), [](const After& now) { return now.blend < -1e-9; })) {
    found.push_back("a blend below 0: more steps were taken than were due");
  }
  if (most_in_a_frame(got) == 1 && time.back() / h > 1.1 * static_cast<double>(got.size())) {
    found.push_back("never more than one step in a frame, and here more are due");
  }
  if (forgets_the_frame_before(got, time, h)) {
    found.push_back(
        "each frame takes the steps that fit into it alone: what the one before left over is lost");
  }
  const double part = time.front() / h - got.front().steps, blend = got.front().blend;
  if (std::abs(blend - (1 - part)) < 1e-9 && std::abs(blend - part) > 1e-3) {
    found.push_back(
        "the blend says how far it still is to the newer state; how far it has come was asked");
  }
  if (std::abs(blend - part * h) < 1e-9) {
    found.push_back("the blend is in seconds; as a share of a step it would be from 0 to 1");
  }
  const double first = std::abs(got.front().picture() * h / time.front() - 1);
  if (first > 1e-10 && first < 2e-6)
    found.push_back("right to seven digits and no further: a float?");
  return found;
}

grade::Plot plot(const std::vector<After>& got, const std::vector<double>& time, double h) {
  grade::Curve yours{"yours", {}, {}}, right{"the time that has gone by", {}, {}};
  for (std::size_t n = 0; n < std::min<std::size_t>(got.size(), 40); ++n) {
    yours.x.push_back(time[n]);
    yours.y.push_back(got[n].picture());
    right.x.push_back(time[n]);
    right.y.push_back(time[n] / h);
  }
  return {"What the screen shows", "time [s]", "steps and blend", {yours, right}};
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

void keeps_time(Student& student, double h, const std::vector<double>& frames,
                const std::string& which, const std::string& hint, const char* before = nullptr) {
  const std::vector<After> got = show(student, h, frames);
  const std::vector<double> time = times(frames);
  const Tolerance within = tolerance(h, frames, time.back());
  const std::size_t bad = first_wrong(got, time, h, within.value);
  const std::size_t n = std::min(bad, frames.size() - 1);

  grade::Finding finding;
  finding.held = bad == frames.size();
  finding.asked = std::to_string(frames.size()) + " frames " + which +
                  ": after each, steps and blend add up to the time, and the blend is under 1";
  finding.input = "h = " + number(h, 17) + ", frames of";
  for (std::size_t i = 0; i < std::min<std::size_t>(n + 1, 6); ++i) {
    finding.input += " " + number(frames[i], 17);
  }
  finding.input += n >= 6 ? " ..." : " s";
  finding.expected = "after frame " + std::to_string(n + 1) + ": " +
                     number(std::floor(time[n] / h)) + " steps and a blend of " +
                     number(time[n] / h - std::floor(time[n] / h));
  finding.got = number(got[n].steps) + " steps and a blend of " + number(got[n].blend);
  finding.error = number(std::abs(got[n].picture() - time[n] / h), 3) + " steps";
  if (got[n].blend < 0 || got[n].blend >= 1) finding.error += ", and the blend is not from 0 to 1";
  finding.tolerance = number(within.value, 2);
  finding.tolerance_from = within.from;
  if (!finding.held) {
    finding.hint = hint;
    finding.diagnoses = recognise(got, time, h);
    if (before) finding.diagnoses.emplace_back(before);
    finding.plot = plot(got, time, h);
  }
  check(finding);
}

std::vector<double> equal(int count, double length) {
  return std::vector<double>(static_cast<std::size_t>(count), length);
}

}  // namespace

TEST_CASE("uneven frames are paid with as many steps as fit into them",
          "[1-test-case/leftover-time][4 points]") {
  Student student;
  Random random;
  const std::string hint =
      "What a frame leaves over belongs to the next one. By how much does a step lessen it?";
  for (const bool again : {false, true}) {
    const double h = 1 / random.between(90, 250);
    std::vector<double> frames;
    for (int n = 0; n < 600; ++n) frames.push_back(random.between(0.008, 0.04));
    keeps_time(student, h, frames, again ? "of a second level" : "of many lengths", hint,
               again ? "the first level was right: something is remembered from it" : nullptr);
  }
}

TEST_CASE("on a fast screen the picture moves by the same amount in every frame",
          "[1-test-case/leftover-time][3 points]") {
  Student student;
  Random random;
  const double h = 1 / random.between(40, 80);
  keeps_time(student, h, equal(300, h / random.between(2.1, 4.9)), "that are shorter than a step",
             "Most frames have no step. What moves the picture in those?");
}

TEST_CASE("on a slow screen several steps are due in a frame, and the rest is kept",
          "[1-test-case/leftover-time][3 points]") {
  Student student;
  Random random;
  const double h = 1 / random.between(200, 400);
  keeps_time(student, h, equal(300, h * (random.whole(2, 6) + random.between(0.2, 0.8))),
             "that are longer than a step",
             "How often must the loop go round, and what is left when it ends?");
}
