// SPDX-License-Identifier: MIT-0
/// @file
/// A leaf in a wind.
#pragma once
#include <string>
#include <vector>

#include "harness.h"
#include "judge/method.h"
#include "judge/random.h"
#include "judge/student.h"
#include "judge/waves.h"

namespace judge::leaf_in_the_wind {

/// A wind that changes over a few metres and within a few seconds.
inline Acceleration draw_wind(Random& random) {
  const Vec mean = random.vector(-1, 1);
  const Waves gusts{random, 2, 6, 3};
  return [=](const Vec& x, const Vec&, double t) { return mean + gusts(x, t); };
}

/// One frame with the drag of backward Euler, in the wind of a place so far on the way to the end
/// and of a time so far on.
inline Method asking(double c, double place, double time) {
  return method("", [=](Vec& x, Vec& v, double t, double h, const Acceleration& wind) {
    v = (v + c * h * wind(x + place * h * v, v, t + time * h)) / (1 + c * h);
    x = x + h * v;
  });
}

struct Leaf {
  double c, h;
  int frames;
  Acceleration wind;
  Start start;

  Path by(Student& student) const {
    student.call(0, {c}, 0);
    return student.watch(start, h, frames, wind, 1);
  }
  Path by(const Method& method) const { return run(method, start, h, frames, 1, wind); }

  /// RK4 in steps of which c h is below 0.2: its error is less than a millionth of a frame's.
  Path truth() const {
    constexpr int parts = 64;
    const Acceleration pushed = [this](const Vec& x, const Vec& v, double t) {
      return c * (wind(x, v, t) - v);
    };
    return run(rk4, start, h / parts, frames * parts, parts, pushed);
  }
};

/// The position and the time at which a leaf may start.
constexpr harness::Bounds start_place{"x", 0, 50}, start_time{"t", -10, 1000, 0};

/// Frame after frame, each leaf's with the others' between.
inline std::vector<Path> by_turns(Student& student, const std::vector<Leaf>& leaves) {
  std::vector<Path> paths;
  for (const Leaf& leaf : leaves)
    paths.push_back({leaf.start.t, leaf.h, 1, {{leaf.start.x, leaf.start.v}}, {}});
  for (int n = 0; n < leaves.front().frames; ++n) {
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      Leaf now = leaves[i];
      const State state = paths[i].states.back();
      now.start = {state.x, state.v, now.start.t + n * now.h};
      now.frames = 1;
      const Path frame = now.by(student);
      paths[i].states.push_back(frame.states.back());
      paths[i].evaluations.insert(paths[i].evaluations.end(), frame.evaluations.begin(),
                                  frame.evaluations.end());
    }
  }
  return paths;
}

/// A leaf that has, or has not, the velocity of a wind that is the same everywhere.
struct Throw {
  Leaf leaf;
  Vec calm;

  static Throw draw(Random& random, double c) {
    const Vec calm = random.vector(-0.5, 0.5), thrown = random.vector(2, 5);
    Start start = random.start();
    start.v = calm + thrown;
    return {{c, 1.0 / 60, 30, [=](const Vec&, const Vec&, double) { return calm; }, start}, calm};
  }

  /// A throw from anywhere: at rest, in still air, or carried along, too.
  static Throw anywhere(Random& random) {
    Throw drawn = draw(random, random.anywhere(harness_bounds::c));
    const Vec calm = random.vector_anywhere(harness_bounds::velocity);
    const Vec v = random.whole(0, 3) == 0 ? calm : random.vector_anywhere(harness_bounds::velocity);
    drawn.calm = calm;
    drawn.leaf.frames = 10;  // after which a thousandth of the throw is left, or less
    drawn.leaf.h = random.anywhere(harness_bounds::h);
    drawn.leaf.start = {random.vector_anywhere(start_place), v, random.anywhere(start_time)};
    drawn.leaf.wind = [=](const Vec&, const Vec&, double) { return calm; };
    return drawn;
  }

  Vec thrown() const { return leaf.start.v - calm; }

  /// The way in all, beyond the air [m].
  Vec way() const { return thrown() / leaf.c; }

  /// The rounding of a velocity [m/s], and of a position [m].
  double rounded() const {
    return rounding(leaf.frames, length(leaf.start.v) + length(calm)).value;
  }
  double rounded_way() const {
    const double with_air = leaf.frames * leaf.h * length(calm);
    return rounding(leaf.frames, length(leaf.start.x) + with_air + length(leaf.start.v)).value;
  }
};

}  // namespace judge::leaf_in_the_wind
