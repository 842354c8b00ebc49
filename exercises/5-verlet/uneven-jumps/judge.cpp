// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "../order.h"
#include "harness.h"
#include "scene.h"

using namespace judge;
using namespace judge::verlet;
using namespace judge::verlet::uneven_jumps;

namespace {

// Frames of 4 to 40 ms: a recording has shorter ones and longer ones.
std::vector<double> draw_frames(Random& random, std::size_t count) {
  std::vector<double> frames(count);
  for (double& h : frames) h = random.between(0.004, 0.04);
  return frames;
}

void moves_right(Student& student, const Flight& flight) {
  const Places expected{"the corrected formula", flight.by_formula()};
  Asked asked{"one frame, " + describe(flight.force),
              flight.in_words(),
              rounding(flight.size()),
              "Which of these numbers is so large, so small or so equal to another that a line of "
              "yours does something of its own?",
              {}};
  const std::vector<Vec> yours = flight.by(student);
  are_places(asked, yours, expected);
}

// The largest error of a free spring's places, at the ends of eight equal parts.
double error_on_spring(Student& student, const std::vector<double>& pattern, double omega,
                       const Start& start, int parts) {
  const auto exact = [&](double t) {
    return std::cos(omega * t) * start.x + std::sin(omega * t) / omega * start.v;
  };
  Flight flight{{harness::Force::spring, {omega, 0}}, exact(0), {}, 0, pattern.back() / parts, {}};
  flight.x_previous = exact(-flight.h_previous);
  for (int n = 0; n < 8 * parts; ++n) {
    for (const double h : pattern) flight.frames.push_back(h / parts);
  }
  const std::vector<Vec> yours = flight.by(student);
  const std::vector<double> ends = flight.ends();
  const std::size_t part = pattern.size() * static_cast<std::size_t>(parts);
  double largest = 0;
  for (std::size_t n = part - 1; n < yours.size(); n += part) {
    const double error = length(yours[n] - exact(ends[n]));
    if (!std::isfinite(error)) return error;
    largest = std::max(largest, error);
  }
  return largest;
}

}  // namespace

TEST_CASE("a throw passes through its true places, whatever the frames",
          "[5-verlet/uneven-jumps][3 points]") {
  Random random;
  const Start start = random.start();
  const double g = random.between(8, 20);
  const auto true_place = [&](double t) {
    return start.x + t * start.v - Vec{0, g * t * t / 2, 0};
  };
  const double last = random.between(0.004, 0.04);
  std::vector<double> frames = draw_frames(random, 30);
  // The shortest and the longest, and two alike.
  frames.insert(frames.end(), harness_bounds::h.asked().begin(), harness_bounds::h.asked().end());
  frames.insert(frames.end(), {0.02, 0.02});
  const Flight flight{
      {harness::Force::falling, {g, 0, 0}}, start.x, true_place(-last), start.t, last, frames};
  Student student;
  Places exact{"true", {}};
  for (const double end : flight.ends()) exact.x.push_back(true_place(end));
  Asked asked{"frames of a throw, g = " + grade::number(g, 17) + " m/s^2 along -y",
              flight.in_words(),
              rounding(static_cast<int>(frames.size()), 1 + length(exact.x.back())),
              "Gravity changes the velocity of the last frame's middle into that of this frame's. "
              "How long is it from one middle to the other?",
              flight.ends()};
  const std::vector<Vec> yours = flight.by(student);
  are_places(asked, yours, exact);
}

TEST_CASE("six frames under a hidden force are those of the corrected formula",
          "[5-verlet/uneven-jumps][2 points]") {
  Random random;
  const Start start = random.start();
  Flight flight{random.wild(), start.x, {}, start.t, random.between(0.05, 0.1), {}};
  flight.x_previous = start.x - flight.h_previous * start.v;
  for (int n = 0; n < 6; ++n) flight.frames.push_back(random.between(0.05, 0.3));
  Student student;
  const Places expected{"the corrected formula", flight.by_formula()};
  Asked asked{"six long frames, " + describe(flight.force), flight.in_words(),
              rounding(6, 1 + length(expected.x.back())),
              "Drag sees the last distance over h_previous, and all is asked for at t. Is one of "
              "these off, or one of the two corrections?",
              flight.ends()};
  const std::vector<Vec> yours = flight.by(student);
  are_places(asked, yours, expected);
}

TEST_CASE("any frame after any other moves any thing right, and each of two by turns",
          "[5-verlet/uneven-jumps][1 point]") {
  Random random;
  Student student;
  constexpr int frames = 200;
  for (int n = 0; n < frames; ++n) {
    const double t = random.anywhere({"t", -10, 1000, 0});
    for (int thing = 0; thing < 2; ++thing) moves_right(student, Flight::anywhere(random, t));
  }
}

TEST_CASE("half as long frames leave a quarter of the error on a spring",
          "[5-verlet/uneven-jumps][2 points]") {
  Random random;
  const double omega = random.between(2, 3);
  const Start start = random.start();
  const std::vector<double> pattern = draw_frames(random, 8);
  Student student;
  Halvings runs{
      "the same uneven frames eight times, then all half as long and twice as many, and so "
      "on, on a free spring with omega = " +
          grade::number(omega, 17) + "/s",
      describe(start) + ", frames",
      {},
      {},
      "An error that only halves: each push is counted, but not by the two frames on whose "
      "border it stands.",
      "An error that stays, however short the frames: the speed or the force is wrong on "
      "average."};
  for (const double h : pattern) runs.input += " " + grade::number(h, 17);
  for (const int parts : {1, 2, 4, 8}) {
    runs.steps.push_back(*std::max_element(pattern.begin(), pattern.end()) / parts);
    runs.errors.push_back(error_on_spring(student, pattern, omega, start, parts));
  }
  has_order_two(runs);
}

TEST_CASE("a fall is as fast as it is, whatever the two frames",
          "[5-verlet/uneven-jumps][2 points]") {
  Student student;
  Random random;
  for (const auto& [last, h] : {std::pair{0.006, 0.04}, {0.035, 0.008}, {0.02, 0.03}}) {
    const double scale = random.between(0.8, 1.2);
    falls_as_fast(student, Fall::draw(random, scale * last, scale * h));
  }
  constexpr int falls = 300;
  for (int n = 0; n < falls; ++n) falls_as_fast(student, Fall::anywhere(random));
}
