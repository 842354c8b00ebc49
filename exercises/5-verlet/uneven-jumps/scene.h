// SPDX-License-Identifier: MIT-0
/// @file
/// Frames of changing length, and where they lead.
///
/// Three places of a throw, and the velocity at the one in the middle.
#pragma once
#include <algorithm>
#include <cmath>

#include "../places.h"
#include "harness.h"
#include "judge/random.h"

namespace judge::verlet::uneven_jumps {

inline constexpr harness::Bounds any_velocity{"v", 0, 300};  ///< [m/s]

/// The length of any frame after a last one, now and then one that is nearly as long.
inline double any_after(Random& random, double last) {
  const auto& h = harness_bounds::h;
  if (random.whole(0, 3) > 0) return random.anywhere(h);
  const double near = last * random.nearly_one(1e-8, 0.1);
  return std::clamp(near, h.smallest(), h.largest());
}

/// The arguments of the student's step.
struct Flight {
  harness::Force force;
  Vec x, x_previous;
  double t = 0, h_previous = 0;  ///< [s]
  std::vector<double> frames;    ///< lengths [s]

  std::vector<Vec> by(Student& student) const {
    const auto numbers = as_numbers(force, x, x_previous, t, h_previous, frames.size(), frames);
    return as_vectors(student.call(0, numbers, 3 * frames.size()));
  }

  /// A flight of one frame of any length after any other, of what is anywhere and has any velocity.
  static Flight anywhere(Random& random, double t) {
    Flight flight{random.any_force(),
                  random.vector_anywhere(harness_bounds::place),
                  {},
                  t,
                  random.anywhere(harness_bounds::h),
                  {}};
    flight.frames = {any_after(random, flight.h_previous)};
    flight.x_previous = flight.x - flight.h_previous * random.vector_anywhere(any_velocity);
    return flight;
  }

  /// The size of a frame's sum: the ratio of the frames is a factor of what places lose.
  double size() const {
    const Vec v = (x - x_previous) / h_previous;
    const double places = length(x) + length(x_previous), both = h_previous + frames[0];
    // Drag goes with the square of a velocity that is as wrong as the places over the frame.
    const double pushes = length(force(x, v, t)) + length(v) * places / h_previous;
    return 1 + length(x) + frames[0] * (places / h_previous + both * pushes);
  }

  /// The places by the corrected formula.
  std::vector<Vec> by_formula() const {
    std::vector<Vec> places{x_previous, x};
    double now = t, last = h_previous;
    for (const double h : frames) {
      const Vec here = places.back(), distance = here - places[places.size() - 2];
      places.push_back(here + h / last * distance +
                       h * (h + last) / 2 * force(here, distance / last, now));
      now += h;
      last = h;
    }
    return {places.begin() + 2, places.end()};
  }

  /// The ends of the frames, from the start on [s].
  std::vector<double> ends() const {
    std::vector<double> ends;
    double now = 0;
    for (const double h : frames) ends.push_back(now += h);
    return ends;
  }

  std::string in_words() const {
    std::string text =
        named("x", x, "x_previous", x_previous, "t", t, "h_previous", h_previous) + ", then h =";
    for (const double h : frames) text += " " + grade::number(h, 17);
    return text;
  }
};

struct Fall {
  Vec x, v, g;
  double h_previous = 0, h = 0;

  static Fall draw(Random& random, double h_previous, double h) {
    const Start start = random.start();
    return {start.x, 3 * start.v, {0, -random.between(8, 20), 0}, h_previous, h};
  }

  /// A fall thrown in any way, pulled to any side; now and then two of its places are one.
  static Fall anywhere(Random& random) {
    constexpr harness::Bounds gravity{"g", 0, 50};
    if (random.whole(0, 7) == 0) {
      // Powers of two, whose sums are exact.
      const double h = 0.25, last = random.whole(0, 1) == 0 ? 0.25 : 0.125;
      const double turned = random.whole(0, 1) == 0 ? h / 2 : -last / 2;
      const Vec g{0, -8, 0};
      const double at_top = random.whole(0, 2) == 0 ? (h - last) / 2 : turned;
      return {{}, -at_top * g, g, last, h};
    }
    Fall fall{random.vector_anywhere(harness_bounds::place), random.vector_anywhere(any_velocity),
              random.vector_anywhere(gravity), random.anywhere(harness_bounds::h), 0};
    fall.h = any_after(random, fall.h_previous);
    return fall;
  }

  double size() const { return 1 + length(x) + (h + h_previous) * (length(v) + length(g)); }

  Vec at(double t) const { return x + t * v + (t * t / 2) * g; }
  Vec by(Student& student) const {
    const auto numbers = as_numbers(at(-h_previous), x, at(h), h_previous, h);
    return as_vectors(student.call(1, numbers, 3))[0];
  }

  std::string in_words() const {
    return named("x_previous", at(-h_previous), "x", x, "x_next", at(h), "h_previous", h_previous,
                 "h", h);
  }
};

inline void falls_as_fast(Student& student, const Fall& fall) {
  const double h = fall.h, last = fall.h_previous;
  // A place loses a rounding, and the quotient divides by the shorter frame.
  const Tolerance near = rounding(fall.size() / std::min(h, last));
  are_places({"the velocity on a throw, g = " + describe(fall.g, 17) + " m/s^2",
              fall.in_words(),
              near,
              "A frame's distance over its length is the velocity in the frame's middle. x lies "
              "half of the one frame from the one, and half of the other from the other.",
              {}},
             {fall.by(student)}, {"the throw's own velocity", {fall.v}});
}

}  // namespace judge::verlet::uneven_jumps
