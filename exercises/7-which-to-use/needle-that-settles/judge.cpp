// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "format_values.h"
#include "harness.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "scene.h"

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

  // A start so far away that it is behind one that trails, too.
  static Beginning draw_fast(Random& random) {
    return {{random.between(-9, -8), random.between(-40, -20)}, random.between(4, 12)};
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

// The size of the numbers that a right answer sums, in position and velocity.
double size(const Beginning& start, const needle::State& before, const Frame& frame) {
  const double way =
      std::abs(before.x) + std::abs(frame.target) + std::abs(frame.u) * (frame.h + 2 / start.omega);
  return (1 + start.omega) * (way + std::abs(frame.u) + std::abs(before.v));
}

/// @param angle  omega h, which says how many they are
Tolerance tiny_steps(double size, double angle) {
  return {(1e-12 * std::min(1.0, angle)) * size + rounding(size).value,
          "the judge takes steps of a thousandth of 1/omega, and what they are off is below this"};
}

/// The part of a state that is judged.
enum Look { place, both };

bool right_when_fresh(const Beginning& start, const needle::State& before, const Frame& frame,
                      const needle::State& right, double tolerance) {
  Student fresh;
  const std::vector<double> said =
      fresh.call(0, {before.x, before.v, start.omega, 1, frame.target, frame.u, frame.h}, 2);
  return larger(std::abs(said[0] - right.x), std::abs(said[1] - right.v)) <= tolerance;
}

// A frame, and where the needle was before and after it.
struct Seen {
  double omega;
  Frame frame;
  needle::State before, right, got;
  Look look = both;

  double apart() const {
    const double off = std::abs(got.x - right.x);
    return look == place ? off : larger(off, std::abs(got.v - right.v));
  }
};

grade::Finding finding_of(const Seen& seen, const Tolerance& tolerance, const std::string& hint) {
  grade::Finding finding = off_by(seen.apart(), tolerance);
  finding.expected = described(seen.right);
  finding.got = described(seen.got);
  if (finding.held) return finding;
  const bool is_place_right = std::abs(seen.got.x - seen.right.x) <= tolerance.value;
  finding.hint = is_place_right
                     ? "The velocity is the derivative of the place: of the bracket, of the "
                       "exponential, and of the target's way."
                     : hint;
  if (is_place_right && (seen.got.x != seen.before.x || seen.got.v != seen.before.v))
    finding.diagnoses = {"the place is right, the velocity is not"};
  return finding;
}

/// The question to which frames belong.
struct Asked {
  std::string what, hint;
  Look look = both;
  std::string says = "";  ///< of a wrong one, if that is known beforehand
};

void check_frames(Student& student, const Beginning& start, const std::vector<Frame>& frames,
                  const Asked& asked) {
  std::vector<double> arguments{start.state.x, start.state.v, start.omega, double(frames.size())};
  for (const Frame& frame : frames) {
    arguments.insert(arguments.end(), {frame.target, frame.u, frame.h});
  }
  const std::vector<double> said = student.call(0, arguments, 2 * frames.size());
  needle::State right = start.state;
  double largest = 0, longest = 0;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    const needle::State before = right, got{said[2 * n], said[2 * n + 1]};
    right = Needle{start.omega}.after(before, frames[n]);
    largest = std::max(largest, size(start, before, frames[n]));
    longest = std::max(longest, start.omega * frames[n].h);
    const Tolerance tolerance = tiny_steps(largest * static_cast<double>(n + 1), longest);
    grade::Finding finding =
        finding_of({start.omega, frames[n], before, right, got, asked.look}, tolerance, asked.hint);
    finding.asked = asked.what + ": frame " + std::to_string(n + 1);
    finding.input = described(start, frames, n);
    if (!finding.held && !asked.says.empty()) finding.diagnoses = {asked.says};
    if (!finding.held && right_when_fresh(start, before, frames[n], right, tolerance.value)) {
      finding.diagnoses = {"as the first frame of a program it is right: what is remembered?"};
    }
    check(finding);
  }
}

// From very short ones to a pause of years, which no loop of short steps gets through; the short
// ones last, since there the wrong ways are hardly told apart.
template <class Velocity>
void frames_of_any_length(Student& student, Random& random, Velocity u, Asked asked) {
  const auto check = [&](const Beginning& start, double target, double with, double h) {
    asked.what = "omega h = " + number(start.omega * h);
    check_frames(student, start, {{target, with, h}}, asked);
  };
  for (const double z : {0.2, 0.01, 1.0, 5.0, 30.0, 1e9}) {
    Beginning start = Beginning::draw(random);
    const double target = random.between(1, 3), with = u();
    // One of them is so fast that it passes its target within the frame.
    if (z == 1) {
      const double way = random.between(2, 4);
      start.state = {target - way, with + random.between(6, 8) * start.omega * way};
    }
    check(start, target, with, z / start.omega);
  }
  // A stand-in for the exponential while omega h is small is worst just below where it ends.
  asked.says =
      "other frames came out right, and one of this length does not: does something else stand in "
      "for the exponential, such as the start of its series?";
  for (double z = 0.1; z > 5e-6; z /= 10) {
    const Beginning start = Beginning::draw_fast(random);
    const double h = z * random.between(0.9, 0.99) / start.omega;
    const double speed = u();
    check(start, random.between(1, 3), speed, h);
  }
}

}  // namespace

TEST_CASE("one frame of any length ends at the place where tiny steps do",
          "[7-which-to-use/needle-that-settles][2 points]") {
  Student student;
  Random random;
  frames_of_any_length(
      student, random, [&] { return random.between(3, 8); },
      {"",
       "How far does a needle trail that has followed its target for long? Measure the way from "
       "there.",
       place});
}

TEST_CASE("to a target that stands still a needle comes as fast as tiny steps do",
          "[7-which-to-use/needle-that-settles][3 points]") {
  Student student;
  Random random;
  frames_of_any_length(
      student, random, [] { return 0.0; },
      {"", "This is the step of the task's formula. The velocity is its derivative."});
}

// Each frame is about as long as a needle takes to settle, so that short steps have to be many. A
// few frames are looked at, each from where the student's own needle was before it.
TEST_CASE("a million frames take no longer than an exact step does",
          "[7-which-to-use/needle-that-settles][2 points]") {
  constexpr std::size_t frames = 1'000'000, looked_at = 20;
  Student student;
  Random random;
  const Beginning start = Beginning::draw(random);
  std::vector<double> arguments{start.state.x, start.state.v, start.omega, double(frames)};
  arguments.reserve(4 + 3 * frames);
  for (std::size_t n = 0; n < frames; ++n) {
    arguments.insert(arguments.end(), {random.between(-10, 10), random.between(-8, 8),
                                       random.between(1, 5) / start.omega});
  }
  const std::vector<double> said = student.call(0, arguments, 2 * frames);
  for (std::size_t n = frames / looked_at; n < frames; n += frames / looked_at) {
    const needle::State before{said[2 * n - 2], said[2 * n - 1]}, got{said[2 * n], said[2 * n + 1]};
    const auto at = arguments.begin() + 4 + static_cast<std::ptrdiff_t>(3 * n);
    const Frame frame{at[0], at[1], at[2]};
    const Beginning from{before, start.omega};
    grade::Finding finding =
        finding_of({start.omega, frame, before, Needle{start.omega}.after(before, frame), got},
                   tiny_steps(size(from, before, frame), 1), "Is a frame alone right?");
    finding.asked = "frame " + std::to_string(n + 1) + " of a million, from where yours was";
    finding.input = described(from, {frame}, 0);
    check(finding);
  }
}

// Two needles of one place each, in one frame after the other of one length: what is remembered of
// the first one is wrong for the second.
TEST_CASE("any needle comes right, fast or at rest, soft or stiff, after any frame",
          "[7-which-to-use/needle-that-settles][1 point]") {
  constexpr harness::Bounds x{"x", -10, 10, 0}, v{"v", -100, 100, 0};
  const auto &u = harness_bounds::u, &omega = harness_bounds::omega, &h = harness_bounds::h;
  Student student;
  Random random;
  const Asked asked{"one of many needles of all kinds",
                    "Which of these numbers is so large, so small or so equal to another that a "
                    "line of yours does something of its own?"};
  constexpr int pairs = 150;
  for (int n = 0; n < pairs; ++n) {
    const double length = random.anywhere(h);
    for (int needle = 0; needle < 2; ++needle) {
      Frame frame{random.anywhere(x), random.anywhere(u), length};
      Beginning start{{random.anywhere(x), random.anywhere(v)}, random.anywhere(omega)};
      if (random.whole(0, 3) == 0) start.state.x = frame.target;
      if (random.whole(0, 3) == 0) start.state.v = frame.u;
      if (random.whole(0, 1) == 0)
        frame.h = std::clamp(random.octaves(1e-3, 100) / start.omega, h.smallest(), h.largest());
      check_frames(student, start, {frame}, asked);
    }
  }
}

TEST_CASE("uneven frames follow a target that moves on",
          "[7-which-to-use/needle-that-settles][1 point]") {
  Student student;
  Random random;
  const Beginning start = Beginning::draw(random);
  const double u = random.between(-8, -3);
  std::vector<Frame> frames;
  for (double target = random.between(1, 3); frames.size() < 40; target = frames.back().end()) {
    frames.push_back({target, u, random.between(0.002, 0.05)});
  }
  check_frames(student, start, frames,
               {"forty frames with one target",
                "The velocity that one frame leaves is the start of the next one."});
}

TEST_CASE("a target that jumps is followed, and the speed is kept",
          "[7-which-to-use/needle-that-settles][1 point]") {
  Student student;
  Random random;
  const Beginning start = Beginning::draw(random);
  std::vector<Frame> frames;
  for (int n = 0; n < 20; ++n) {
    const double u = n % 4 == 0 ? 0 : random.between(-8, 8);
    frames.push_back({random.between(-10, 10), u, random.between(0.01, 0.2)});
  }
  check_frames(
      student, start, frames,
      {"a new target in each frame", "Is anything kept from the frame before besides x and v?"});
}
