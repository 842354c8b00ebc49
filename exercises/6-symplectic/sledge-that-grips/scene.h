// SPDX-License-Identifier: MIT-0
/// @file
/// A sledge, as it should be stepped, as others step it, and as the student does.
#pragma once
#include <string>
#include <vector>

#include "format_values.h"
#include "harness.h"
#include "judge/describe.h"
#include "judge/numbers.h"
#include "judge/random.h"
#include "judge/student.h"

namespace sledge {

using judge::State;

struct Sledge {
  Vec along;
  double c_along, c_across;

  static Sledge draw(judge::Random& random) {
    const Vec way = random.start().x;
    return {way / length(way), random.between(0.5, 1.5), random.between(50, 150)};
  }

  /// The right step: pushed, then braked, then moved.
  void step(State& s, double t, double h, const harness::Force& push) const {
    const Vec pushed = s.v + h * push(s.x, s.v, t), glide = dot(pushed, along) * along;
    s.v = glide / (1 + c_along * h) + (pushed - glide) / (1 + c_across * h);
    s.x += h * s.v;
  }
};

struct Ride {
  Sledge sledge;
  judge::Start start;
  harness::Force push;
  double h = 0;
  int steps = 0, every = 1;

  /// One step of any sledge from anywhere; along an axis, at rest, or without a brake, too.
  static Ride anywhere(judge::Random& random) {
    constexpr harness::Bounds x{"x", 0, 100}, v{"v", 0, 100}, t{"t", -10, 1000, 0};
    Ride ride;
    ride.sledge = {random.vector_anywhere(harness_bounds::along),
                   random.anywhere(harness_bounds::drag), random.anywhere(harness_bounds::drag)};
    ride.start = {random.vector_anywhere(x), random.vector_anywhere(v), random.anywhere(t)};
    ride.push = random.any_force();
    // Nearly along the runners.
    if (random.whole(0, 3) == 0) {
      const Vec aside = random.vector_anywhere(v);
      const Vec across = random.octaves(1e-9, 1) * aside;
      ride.start.v = random.anywhere(v) * ride.sledge.along + across;
    }
    ride.h = random.anywhere(harness_bounds::h);
    ride.steps = 1;
    return ride;
  }

  /// The size of the numbers that a step sums before it brakes.
  double size() const {
    const Vec a = push(start.x, start.v, start.t);
    return 1 + length(start.x) + (1 + h) * (length(start.v) + h * length(a));
  }

  std::vector<State> by_method() const {
    State s{start.x, start.v};
    std::vector<State> states;
    for (int n = 0; n < steps; ++n) {
      sledge.step(s, start.t + n * h, h, push);
      if ((n + 1) % every == 0) states.push_back(s);
    }
    return states;
  }

  std::vector<State> by(judge::Student& student) const {
    const auto numbers = judge::as_numbers(sledge.along, sledge.c_along, sledge.c_across, push,
                                           start.x, start.v, start.t, h, steps, every);
    return judge::as_states(
        student.call(0, numbers, static_cast<std::size_t>(6 * (steps / every))));
  }

  std::string input() const {
    return judge::describe(start) + ", " + judge::named("h", h) + "; runners along " +
           judge::describe(sledge.along) + ", drag " + grade::number(sledge.c_along, 17) +
           "/s and " + grade::number(sledge.c_across, 17) + "/s";
  }
};

}  // namespace sledge
