// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "format_values.h"
#include "judge/diagnose.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"

using namespace judge;
using grade::number;

namespace {

struct Frame {
  double target, h;
};

struct Needle {
  double x, v, omega;

  static Needle draw(Random& random) {
    return {random.between(-2, 2), random.between(-20, 20), random.between(4, 12)};
  }

  void exact(const Frame& frame) {
    const double y = x - frame.target, left = std::exp(-omega * frame.h);
    const double rate = v + omega * y;
    x = frame.target + (y + rate * frame.h) * left;
    v = (rate - omega * (y + rate * frame.h)) * left;
  }
};

std::string described(const Needle& start, const std::vector<Frame>& frames, std::size_t last) {
  std::string text = "x = " + number(start.x, 17) + ", v = " + number(start.v, 17) +
                     ", omega = " + number(start.omega, 17) + "; target and h of each frame:";
  for (std::size_t n = 0; n <= last; ++n) {
    text += " " + number(frames[n].target, 17) + ", " + number(frames[n].h, 17) + ";";
  }
  return text;
}

// What may have been written instead, for one frame; recognised to ten digits.
std::string recognised(const Needle& start, const Frame& frame, double x, double v) {
  const double h = frame.h, omega = start.omega, y = start.x - frame.target;
  const auto alike = [](double a, double b) {
    return std::abs(a - b) <= 1e-10 * (1 + std::abs(b));
  };
  Needle right = start;
  right.exact(frame);
  if (x == start.x && v == start.v) return "nothing moves";
  if (alike(x, right.x)) return "the place is right, the velocity is not";
  if (alike(v, right.v)) return "the velocity is right, the place is not";
  if (alike(x + frame.target, right.x) || alike(x, right.x - frame.target))
    return "this is the way that is left; the needle is there plus the target";
  if (alike(x, frame.target + y * std::exp(-omega * h)))
    return "this is a needle without a velocity of its own: the bracket has one more term";
  const double kicked = start.v + h * (-omega * omega * y - 2 * omega * start.v);
  if (alike(x, start.x + h * kicked)) return "this is symplectic Euler";
  if (alike(x, start.x + h * start.v)) return "this is Euler's method";
  const double z = omega * h, lowe = 1 / (1 + z + 0.48 * z * z + 0.235 * z * z * z);
  if (alike(x, frame.target + (y + (start.v + omega * y) * h) * lowe))
    return "this is 1 / (1 + z + 0.48 z^2 + 0.235 z^3) in place of exp(-z): close, and "
           "not exact";
  return "";
}

void check_frames(Student& student, const Needle& start, const std::vector<Frame>& frames,
                  const std::string& asked, const std::string& hint) {
  std::vector<double> arguments{start.x, start.v, start.omega, double(frames.size())};
  for (const Frame& frame : frames) arguments.insert(arguments.end(), {frame.target, frame.h});
  const std::vector<double> said = student.call(0, arguments, 2 * frames.size());
  Needle right = start;
  double size = 0;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    const Needle before = right;
    right.exact(frames[n]);
    const double y = std::abs(before.x) + std::abs(frames[n].target);
    size = std::max(size, (y + std::abs(before.v)) * (1 + before.omega) * (1 + before.omega));
    const Tolerance tolerance = rounding(size * static_cast<double>(n + 1));
    const double x = said[2 * n], v = said[2 * n + 1];
    const double apart = std::max(std::abs(x - right.x), std::abs(v - right.v));
    grade::Finding finding = off_by(apart, tolerance);
    finding.asked = asked + ": frame " + std::to_string(n + 1);
    finding.input = described(start, frames, n);
    finding.expected = "x = " + number(right.x, 12) + ", v = " + number(right.v, 12);
    finding.got = "x = " + number(x, 12) + ", v = " + number(v, 12);
    if (!finding.held) {
      finding.hint = hint;
      const std::string seen = n == 0 ? recognised(before, frames[n], x, v) : "";
      if (!seen.empty()) finding.diagnoses = {seen};
      for (const std::string& found : judge::diagnose(x, right.x))
        finding.diagnoses.push_back("the place: " + found);
    }
    check(finding);
  }
}

}  // namespace

TEST_CASE("one frame of any length ends where the formula says",
          "[7-which-to-use/needle-that-settles][4 points]") {
  Student student;
  Random random;
  for (const double z : {0.01, 0.2, 1.0, 5.0, 30.0}) {
    Needle start = Needle::draw(random);
    const double target = random.between(1, 3);
    // One of them is so fast that it passes its target within the frame.
    if (z == 1) start.v = random.between(3, 4) * start.omega * (target - start.x);
    check_frames(
        student, start, {{target, z / start.omega}}, "omega h = " + number(z),
        "Is each line made of the old x and the old v? A fast needle may pass its target.");
  }
}

TEST_CASE("uneven frames that add up end where one frame does",
          "[7-which-to-use/needle-that-settles][3 points]") {
  Student student;
  Random random;
  const Needle start = Needle::draw(random);
  const double target = random.between(1, 3);
  std::vector<Frame> frames;
  for (int n = 0; n < 40; ++n) frames.push_back({target, random.between(0.002, 0.05)});
  check_frames(student, start, frames, "forty frames with one target",
               "The velocity that one frame leaves is the start of the next one.");
}

TEST_CASE("a target that jumps is followed, and the speed is kept",
          "[7-which-to-use/needle-that-settles][3 points]") {
  Student student;
  Random random;
  const Needle start = Needle::draw(random);
  std::vector<Frame> frames;
  for (int n = 0; n < 20; ++n) {
    frames.push_back({random.between(-10, 10), random.between(0.01, 0.2)});
  }
  check_frames(student, start, frames, "a new target in each frame",
               "Is anything kept from the frame before besides x and v?");
}
