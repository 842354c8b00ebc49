// SPDX-License-Identifier: MIT-0
/// @file
/// Three places of a throw, and the velocity at the one in the middle.
#pragma once
#include <cmath>
#include <utility>

#include "../places.h"
#include "judge/random.h"

namespace judge::verlet::uneven_jumps {

struct Fall {
  Vec x, v;
  double g = 0, h_previous = 0, h = 0;

  static Fall draw(Random& random, double h_previous, double h) {
    const Start start = random.start();
    return {start.x, 3 * start.v, random.between(8, 20), h_previous, h};
  }

  Vec at(double t) const { return x + t * v - Vec{0, g * t * t / 2, 0}; }
  Vec over(double from, double to) const { return (at(to) - at(from)) / (to - from); }

  Vec by(Student& student) const {
    const Vec a = at(-h_previous), b = at(h);
    return as_places(
        student.call(1, {a.x, a.y, a.z, x.x, x.y, x.z, b.x, b.y, b.z, h_previous, h}, 3))[0];
  }

  std::string in_words() const {
    return "x_previous = " + describe(at(-h_previous), 17) + ", x = " + describe(x, 17) +
           ", x_next = " + describe(at(h), 17) + ", h_previous = " + grade::number(h_previous, 17) +
           ", h = " + grade::number(h, 17);
  }
};

inline void falls_as_fast(Student& student, const Fall& fall) {
  const double h = fall.h, last = fall.h_previous;
  // A place loses a rounding, and the quotient divides by the shorter frame.
  const Tolerance near = rounding((1 + length(fall.x)) / std::min(h, last));
  are_places({"the velocity on a throw, g = " + grade::number(fall.g, 17) + " m/s^2 along -y",
              fall.in_words(),
              near,
              "A frame's distance over its length is the velocity in the frame's middle. x lies "
              "half of the one frame from the one, and half of the other from the other.",
              {}},
             {fall.by(student)}, {"the throw's own velocity", {fall.v}},
             {{"the whole distance over the whole time: the velocity half way between the two "
               "other places",
               {fall.over(-last, h)}},
              {"the velocity of the last frame's middle", {fall.over(-last, 0)}},
              {"the velocity of the next frame's middle", {fall.over(0, h)}},
              {"the plain mean of both frames' velocities, which is right for even frames",
               {(fall.over(-last, 0) + fall.over(0, h)) / 2}},
              {"half of the right one", {fall.v / 2}},
              {"minus the right one: x_next is later than x_previous", {-fall.v}},
              {"the right one times the whole time: the weights should add up to one",
               {(h + last) * fall.v}}});
}

}  // namespace judge::verlet::uneven_jumps
