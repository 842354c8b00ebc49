// SPDX-License-Identifier: MIT-0
// Where the level's things are in each frame of its film. Their places and sizes are those of the
// picture.
#include <cmath>
#include <numbers>

#include "chain.h"
#include "film.h"
#include "judge/numbers.h"
#include "things.h"

namespace level {
namespace {

using Frames = std::vector<double>;

Vec between(const Vec& from, const Vec& to, double share) {
  return from + share * (to - from);
}

/// A thing that was stepped, in the frames of a screen: between its last two states, by the time
/// that has gone by.
std::vector<Vec> in_frames(const std::vector<Vec>& states, const Frames& frames) {
  std::vector<Vec> seen;
  double time = 0;
  for (const double frame : frames) {
    time += frame;
    const auto taken = static_cast<std::size_t>(time / h + 1e-9);
    const std::size_t last = std::min(std::max<std::size_t>(1, taken), states.size() - 1);
    const double blend = std::min(1.0, std::max(0.0, time / h - static_cast<double>(taken)));
    seen.push_back(between(states[last - 1], states[last], blend));
  }
  return seen;
}

int steps_in(const Frames& frames) {
  double time = 0;
  for (const double frame : frames) time += frame;
  return static_cast<int>(time / h) + 2;
}

/// The runner, to and fro along the ground.
Vec runner(double time) {
  return {11 * std::sin(0.8 * time), 0.6, 0};
}

}  // namespace

Paths clock_paths(judge::Student& whose, const Frames& frames) {
  std::vector<double> asked = judge::as_numbers(0, h, frames.size());
  for (const double frame : frames) judge::append(asked, judge::as_numbers(frame, 1));
  const std::vector<double> told = whose.call(0, asked, 3 * frames.size());
  std::vector<Vec> seen;
  double taken = 0;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    taken += told[3 * n];
    seen.push_back(between(runner((taken - 1) * h), runner(taken * h), told[3 * n + 1]));
  }
  return {seen};
}

Paths camera_paths(judge::Student& whose, const Frames& frames) {
  constexpr double part = 0.1, fastest = 12;
  const Vec above{0, 1.6, 0};
  std::vector<Vec> seen;
  Vec camera = runner(0) + above;
  double time = 0;
  for (const double frame : frames) {
    const auto asked = judge::as_numbers(camera, runner(time) + above, part, fastest, frame);
    camera = judge::as_vectors(whose.call(0, asked, 3)).front();
    time += frame;
    seen.push_back(camera);
  }
  return {seen};
}

Paths spring_paths(judge::Student& whose, const Frames& frames) {
  constexpr double omega = 40, amplitude = 0.1, enlarged = 10;
  const double told = whose.call(1, {omega, h}, 1)[0];
  const int count = steps_in(frames);
  const std::vector<double> swing =
      whose.call(0, judge::as_numbers(amplitude, 0, h, grade::within(told, 0.1, 1000), 0, count),
                 2 * static_cast<std::size_t>(count));
  const Vec rest{-12, 6, 0};
  std::vector<Vec> states{rest + Vec{0, enlarged * amplitude, 0}};
  for (std::size_t n = 0; n < swing.size(); n += 2)
    states.push_back(rest + Vec{0, enlarged * swing[n], 0});
  return {in_frames(states, frames)};
}

Paths rope_paths(judge::Student& whose, const Frames& frames) {
  constexpr double enlarged = 4;
  const Vec hook{-3, 13, 0};
  Chain chain;
  std::vector<std::vector<Vec>> states(Chain::links + 1);
  for (int n = 0; n <= steps_in(frames); ++n) {
    for (std::size_t i = 0; i < states.size(); ++i)
      states[i].push_back(hook + enlarged * chain.x[i]);
    chain.step(whose, n * h);
  }
  Paths all;
  for (const std::vector<Vec>& point : states) all.push_back(in_frames(point, frames));
  return all;
}

/// Forth for the first half, and wound back in the second.
Paths replay_paths(judge::Student& whose, const Frames& frames) {
  constexpr double turn = 5, distance = 3;
  const Vec planet{10.5, 10, 0};
  const double rate = 2 * std::numbers::pi / turn;
  const harness::Force pull{harness::Force::orbit, {rate * rate * std::pow(distance, 3)}};
  const int half = steps_in(frames) / 2 + 1;
  const judge::Path forth =
      whose.run({{distance, 0, 0}, {0, 0.85 * rate * distance, 0}}, h, half, 1, pull);
  const judge::State turned = forth.states.back();
  const judge::Path back = whose.run({turned.x, turned.v, half * h}, -h, half, 1, pull, 1);
  std::vector<Vec> states;
  for (const judge::State& state : forth.states) states.push_back(planet + state.x);
  for (const judge::State& state : back.states) states.push_back(planet + state.x);
  return {in_frames(states, frames)};
}

/// A flight is asked where it ends; for a film it is asked so often that it can be seen.
Paths shuttle_paths(judge::Student& whose, const Frames& frames) {
  constexpr double e = 0.8, mu = 0.6, enlarged = 2.6;
  const Vec planet{5.2, 5.5, 0};
  const Acceleration pull = [](const Vec& x, const Vec&, double) {
    const double r2 = dot(x, x);
    return (-mu / (r2 * std::sqrt(r2))) * x;
  };
  const judge::Start start{{1 - e, 0, 0}, {0, std::sqrt(mu * (1 + e) / (1 - e)), 0}};
  std::vector<Vec> seen;
  double time = 0;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    time += frames[n];
    const bool is_asked = n % 6 == 0;
    seen.push_back(is_asked ? planet + enlarged * whose.watch(start, time, 1, pull).states[1].x
                            : seen.back());
  }
  return {seen};
}

std::vector<double> film_frames() {
  constexpr double longest = 10;
  std::vector<double> frames;
  double time = 0;
  const Screen uneven = screens().back();
  for (const double frame : uneven.frames) {
    if (time > longest) break;
    time += frame;
    frames.push_back(frame);
  }
  return frames;
}

}  // namespace level
