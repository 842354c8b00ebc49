// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "format_values.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "needle.h"

using namespace judge;
using grade::number;
using needle::Frame;
using needle::Needle;

namespace {

struct Beginning {
  needle::State state;
  double omega;

  static Beginning draw(Random& random) {
    return {{random.between(-2, 2), random.between(-20, 20)}, random.between(4, 12)};
  }
};

std::string described(const Beginning& start, const std::vector<Frame>& frames, std::size_t last) {
  std::string text = "x = " + number(start.state.x, 17) + ", v = " + number(start.state.v, 17) +
                     ", omega = " + number(start.omega, 17) + "; target, u and h of each frame:";
  for (std::size_t n = 0; n <= last; ++n) {
    text += (n > 0 ? "; " : " ") + number(frames[n].target, 17) + ", " + number(frames[n].u, 17) +
            ", " + number(frames[n].h, 17);
  }
  return text;
}

std::string described(const needle::State& state) {
  return "x = " + number(state.x, 12) + ", v = " + number(state.v, 12);
}

// How large the numbers are that a right answer sums, in place and velocity.
double size(const Beginning& start, const needle::State& before, const Frame& frame) {
  const double way = std::abs(before.x) + std::abs(frame.target) + std::abs(frame.u) * frame.h;
  return (1 + start.omega) * (1 + start.omega) * (way + std::abs(frame.u) + std::abs(before.v));
}

Tolerance tiny_steps(double size) {
  return {1e-12 * size,
          "the judge takes steps of a thousandth of 1/omega, and what they are off is below this"};
}

bool right_when_fresh(const Beginning& start, const needle::State& before, const Frame& frame,
                      const needle::State& right, double tolerance) {
  Student fresh;
  const std::vector<double> said =
      fresh.call(0, {before.x, before.v, start.omega, 1, frame.target, frame.u, frame.h}, 2);
  return std::max(std::abs(said[0] - right.x), std::abs(said[1] - right.v)) <= tolerance;
}

void check_frames(Student& student, const Beginning& start, const std::vector<Frame>& frames,
                  const std::string& asked, const std::string& hint) {
  std::vector<double> arguments{start.state.x, start.state.v, start.omega, double(frames.size())};
  for (const Frame& frame : frames) {
    arguments.insert(arguments.end(), {frame.target, frame.u, frame.h});
  }
  const std::vector<double> said = student.call(0, arguments, 2 * frames.size());
  needle::State right = start.state;
  double largest = 0;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    const needle::State before = right, got{said[2 * n], said[2 * n + 1]};
    right = Needle{start.omega}.after(before, frames[n]);
    largest = std::max(largest, size(start, before, frames[n]));
    const double apart = std::max(std::abs(got.x - right.x), std::abs(got.v - right.v));
    const Tolerance tolerance = tiny_steps(largest * static_cast<double>(n + 1));
    grade::Finding finding = off_by(apart, tolerance);
    finding.asked = asked + ": frame " + std::to_string(n + 1);
    finding.input = described(start, frames, n);
    finding.expected = described(right);
    finding.got = described(got);
    if (!finding.held) {
      finding.hint = needle::alike(got.x, right.x)
                         ? "The velocity is the derivative of the place: of the bracket, of the "
                           "exponential, and of the target's way."
                         : hint;
      const std::string seen = needle::recognise(start.omega, before, frames[n], got);
      if (!seen.empty()) finding.diagnoses = {seen};
      if (right_when_fresh(start, before, frames[n], right, tolerance.value)) {
        finding.diagnoses = {"as the first frame of a program it is right: what is remembered?"};
      }
    }
    check(finding);
  }
}

}  // namespace

TEST_CASE("one frame of any length ends where tiny steps do",
          "[7-which-to-use/needle-that-settles][4 points]") {
  Student student;
  Random random;
  // The last one is a pause of years, which no loop of short steps gets through.
  for (const double z : {0.2, 0.01, 1.0, 5.0, 30.0, 1e9}) {
    Beginning start = Beginning::draw(random);
    const double target = random.between(1, 3), u = random.between(3, 8);
    // One of them is so fast that it passes its target within the frame.
    if (z == 1) start.state.v = u + random.between(3, 4) * start.omega * (target - start.state.x);
    check_frames(student, start, {{target, u, z / start.omega}}, "omega h = " + number(z),
                 "How far does a needle trail that has followed its target for long? Measure the "
                 "way from there.");
  }
}

TEST_CASE("uneven frames follow a target that moves on",
          "[7-which-to-use/needle-that-settles][3 points]") {
  Student student;
  Random random;
  const Beginning start = Beginning::draw(random);
  const double u = random.between(-8, -3);
  std::vector<Frame> frames;
  for (double target = random.between(1, 3); frames.size() < 40; target = frames.back().end()) {
    frames.push_back({target, u, random.between(0.002, 0.05)});
  }
  check_frames(student, start, frames, "forty frames with one target",
               "The velocity that one frame leaves is the start of the next one.");
}

TEST_CASE("a target that jumps is followed, and the speed is kept",
          "[7-which-to-use/needle-that-settles][3 points]") {
  Student student;
  Random random;
  const Beginning start = Beginning::draw(random);
  std::vector<Frame> frames;
  for (int n = 0; n < 20; ++n) {
    const double u = n % 4 == 0 ? 0 : random.between(-8, 8);
    frames.push_back({random.between(-10, 10), u, random.between(0.01, 0.2)});
  }
  check_frames(student, start, frames, "a new target in each frame",
               "Is anything kept from the frame before besides x and v?");
}
