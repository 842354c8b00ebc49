// SPDX-License-Identifier: MIT-0
/// @file
/// A leaf in a wind, and what else is made of its frames.
#pragma once
#include <string>
#include <vector>

#include "judge/method.h"
#include "judge/random.h"
#include "judge/student.h"
#include "judge/waves.h"

namespace judge::leaf_in_the_wind {

/// It changes over a few metres and within a few seconds.
inline Acceleration draw_wind(Random& random) {
  const Vec mean = random.vector(-1, 1);
  const Waves gusts{random, 2, 6, 3};
  return [=](const Vec& x, const Vec&, double t) { return mean + gusts(x, t); };
}

/// One frame with the drag of backward Euler, in the wind of a place so far on the way to the end
/// and of a time so far on.
inline Method asking(const std::string& name, double c, double place, double time) {
  return method(name, [=](Vec& x, Vec& v, double t, double h, const Acceleration& wind) {
    v = (v + c * h * wind(x + place * h * v, v, t + time * h)) / (1 + c * h);
    x = x + h * v;
  });
}

inline std::vector<Method> known(double c) {
  const auto explicit_drag = [c](Vec& x, Vec& v, double t, double h, const Acceleration& wind) {
    const Vec w = wind(x, v, t), old = v;
    v = v + c * h * (w - v);
    x = x + h * old;
  };
  const auto no_mass = [](Vec& x, Vec& v, double t, double h, const Acceleration& wind) {
    v = wind(x + h / 2 * v, v, t + h / 2);
    x = x + h * v;
  };
  const auto trapezoid = [c](Vec& x, Vec& v, double t, double h, const Acceleration& wind) {
    const Vec old = v, w = wind(x + h / 2 * v, v, t + h / 2);
    v = (v + c * h * (w - 0.5 * v)) / (1 + c * h / 2);
    x = x + h / 2 * (old + v);
  };
  return {
      method("the trapezoid rule for the drag, which turns a throw round above c h = 2", trapezoid),
      asking("backward Euler that asks at the start of the frame", c, 0, 0),
      asking("backward Euler that asks at the end of the frame", c, 1, 1),
      asking("backward Euler that asks half a frame ahead, but at the old place", c, 0, 0.5),
      method("Euler's method", explicit_drag),
      method("the motion of something without mass", no_mass)};
}

struct Leaf {
  double c, h;
  int frames;
  Acceleration wind;
  Start start;

  Path by(Student& student) const {
    return student.watch(start, h, frames, wind, static_cast<int>(c));
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

}  // namespace judge::leaf_in_the_wind
