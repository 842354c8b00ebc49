// SPDX-License-Identifier: MIT-0
/// @file
/// A small game that can be replayed and rolled back: plain data, steps of one length, and inputs
/// with the number of their step.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "shelf/bounce.h"
#include "shelf/jump.h"
#include "shelf/link.h"

// [world]
/// What a player presses in one step.
struct Input {
  bool jumps = false, left = false, right = false;
};

/// All that the game remembers. To save it, copy it.
struct World {
  double x = 0, height = 0, rises = 0;      // a player
  double ball = 3, ball_speed = 0;          // a ball
  std::array<double, 11> rope{}, before{};  // and a rope that he pulls
  std::array<double, 10> tension{};
  long long step = 0;
};
// [world]

/// The game at its start, with the rope behind the player.
inline World begin() {
  World world;
  for (std::size_t i = 0; i < world.rope.size(); ++i) {
    world.rope[i] = world.before[i] = -0.2 * double(i);
  }
  return world;
}

// [advance]
/// One step, the same on every machine: it asks for no clock, no frame and no random number.
inline void advance(World& world, const Input& input) {
  constexpr double h = 1 / 60.0;
  constexpr auto jump = shelf::jump_to(2.0, 0.35);
  if (input.jumps && world.height == 0) world.rises = jump.speed;
  shelf::jump_step(world.height, world.rises, jump.gravity, jump.gravity, h);
  if (world.height <= 0) world.height = world.rises = 0;
  world.x += h * 6 * (int(input.right) - int(input.left));

  const shelf::Plane<double, double> floor{1, 0, 0.9, 0, 0.1};
  const auto dot = [](double a, double b) { return a * b; };
  shelf::bounce_step(world.ball, world.ball_speed, -9.81, h, floor, dot);

  std::array<double, 11> w;
  w.fill(100);
  w[0] = 0;
  world.rope[0] = world.x;
  const auto norm = [](double a) { return std::abs(a); };
  const auto anywhere = [](double a) { return a; };
  shelf::rope_step(world.rope, world.before, world.tension, w, w.size(), shelf::Rope<double>{0.2},
                   0.0, h, norm, anywhere);
  ++world.step;
}
// [advance]

// [rollback]
/// A machine that hears of some inputs late. Until then it takes the last one that it knows.
struct Machine {
  World now = begin();
  std::vector<World> saved;   // before each step
  std::vector<Input> inputs;  // of each step, heard or guessed
  std::vector<bool> is_heard;

  /// Up to a step: what isn't known is the last that is.
  void guess(std::size_t step) {
    while (inputs.size() <= step) {
      inputs.push_back(inputs.empty() ? Input() : inputs.back());
      is_heard.push_back(false);
    }
  }

  /// A step with what is known.
  void tick() {
    const std::size_t n = std::size_t(now.step);
    guess(n);
    saved.push_back(now);
    advance(now, inputs[n]);
  }

  /// An input arrives. If its step is over, go back to before it, and step again.
  void hear(std::size_t step, const Input& input) {
    const std::size_t reached = std::size_t(now.step);
    guess(step);  // the other machine may be ahead
    inputs[step] = input;
    is_heard[step] = true;
    for (std::size_t n = step + 1; n < inputs.size() && !is_heard[n]; ++n) {
      inputs[n] = input;
    }
    if (step >= reached) return;
    now = saved[step];
    saved.resize(step);
    while (std::size_t(now.step) < reached) tick();
  }
};
// [rollback]
