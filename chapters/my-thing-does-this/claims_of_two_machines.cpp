// SPDX-License-Identifier: MIT-0
// What the page of two machines says.
#include <algorithm>
#include <bit>
#include <catch2/catch_test_macros.hpp>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "frames/recorded.h"
#include "rollback.h"
#include "shelf/fixed_step.h"

namespace {

constexpr std::size_t minute = 3600;

// What a restless player presses.
std::vector<Input> pressed() {
  std::vector<Input> inputs;
  unsigned dice = 1;
  for (std::size_t n = 0; n < minute; ++n) {
    dice = dice * 1664525u + 1013904223u;
    inputs.push_back({(dice >> 27) == 0, (n / 50) % 3 == 0, (dice >> 24) % 2 == 0});
  }
  return inputs;
}

std::vector<std::uint64_t> bits(const World& world) {
  std::vector<double> numbers{world.x, world.height, world.rises, world.ball, world.ball_speed};
  for (const auto* some : {&world.rope, &world.before}) {
    numbers.insert(numbers.end(), some->begin(), some->end());
  }
  numbers.insert(numbers.end(), world.tension.begin(), world.tension.end());
  std::vector<std::uint64_t> all{std::uint64_t(world.step)};
  for (const double number : numbers) all.push_back(std::bit_cast<std::uint64_t>(number));
  return all;
}

World played(const std::vector<Input>& inputs) {
  World world = begin();
  for (const Input& input : inputs) advance(world, input);
  return world;
}

template <class Frame>
World played_by_frames(const std::vector<Input>& inputs, Frame&& frame) {
  World world = begin();
  shelf::FixedStep<> clock{1 / 60.0};
  while (clock.steps < std::int64_t(minute)) {
    clock.frame(frame(), [&](double) {
      if (world.step < std::int64_t(minute)) advance(world, inputs[std::size_t(world.step)]);
    });
  }
  return world;
}

}  // namespace

TEST_CASE("A minute of the game, played again from its inputs, ends equal to the bit") {
  const World once = played(pressed());
  CHECK(bits(once) == bits(played(pressed())));
  CHECK(once.step == std::int64_t(minute));
  CHECK(std::abs(once.x) > 1);
  // It tells games apart: one step without its jump ends elsewhere.
  std::vector<Input> other = pressed();
  other[1800].left = !other[1800].left;
  CHECK(bits(once) != bits(played(other)));
}

TEST_CASE("From even frames and from recorded ones the game makes the same minute, to the bit") {
  frames::Playback frame;
  const World even = played_by_frames(pressed(), [] { return 1 / 75.0; });
  CHECK(bits(even) == bits(played_by_frames(pressed(), [&] { return frame.next(); })));
  CHECK(bits(even) == bits(played(pressed())));
}

TEST_CASE(
    "A machine that hears every input seven steps late ends a minute with the same game as one "
    "that hears all at once, to the bit") {
  const std::vector<Input> inputs = pressed();
  constexpr std::size_t late = 7;
  Machine machine;
  std::size_t wrong = 0;
  for (std::size_t n = 0; n < minute + late; ++n) {
    if (n < minute) machine.tick();
    if (n < late) continue;
    const Input& guess = machine.inputs[n - late];
    const Input& truth = inputs[n - late];
    wrong += guess.jumps != truth.jumps || guess.left != truth.left || guess.right != truth.right;
    machine.hear(n - late, truth);
  }
  CHECK(wrong > 100);
  CHECK(bits(machine.now) == bits(played(inputs)));
}

TEST_CASE(
    "A machine that hears inputs up to eight steps ahead and twelve late, out of order, ends with "
    "the same game as one that hears all at once") {
  const std::vector<Input> inputs = pressed();
  std::vector<std::vector<std::size_t>> heard(minute);  // of which steps it hears after each
  unsigned dice = 7;
  for (std::size_t n = 0; n < minute; ++n) {
    dice = dice * 1664525u + 1013904223u;
    const std::size_t when = n + dice % 21 > 8 ? n + dice % 21 - 8 : 0;
    heard[std::min(when, minute - 1)].push_back(n);
  }
  Machine machine;
  std::size_t ahead = 0;
  for (std::size_t n = 0; n < minute; ++n) {
    machine.tick();
    for (const std::size_t step : heard[n]) {
      ahead += step >= std::size_t(machine.now.step);
      machine.hear(step, inputs[step]);
    }
  }
  CHECK(ahead > 100);
  CHECK(bits(machine.now) == bits(played(inputs)));
}

TEST_CASE("Seven headers call a function of the C library whose last bit is not settled") {
  const std::regex call(
      R"(std::(sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|expm1|log|log1p|pow|hypot|cbrt)\b)");
  std::set<std::string> found;
  for (const char* folder : {CODE "/integrate", CODE "/shelf"}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      std::stringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      const std::string code = std::regex_replace(text.str(), std::regex("//[^\n]*"), "");
      if (std::regex_search(code, call)) found.insert(entry.path().filename().string());
    }
  }
  CHECK(found == std::set<std::string>{"dopri5.h", "linear_damping.h", "orientation.h",
                                       "quadratic_drag.h", "smooth_damp.h", "soft_constraint.h",
                                       "spring_exact.h"});
}
