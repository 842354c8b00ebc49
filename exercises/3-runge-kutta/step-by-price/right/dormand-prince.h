// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline constexpr double rows[7][7] = {
    {},
    {1.0 / 5},
    {3.0 / 40, 9.0 / 40},
    {44.0 / 45, -56.0 / 15, 32.0 / 9},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
    {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
inline constexpr double difference[7] = {71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                                         -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

struct Motion {
  Vec x, v;
};

inline Motion sum(const double* row, const Motion* k, int count) {
  Motion total;
  for (int j = 0; j < count; ++j) {
    total.x += row[j] * k[j].x;
    total.v += row[j] * k[j].v;
  }
  return total;
}

// Stops before the step in which it has passed the origin, if it is told to.
struct Stopped {
  double done, step;
};

inline Stopped fly_to(Vec& x, Vec& v, double t, double duration, double tolerance,
                      const Acceleration& acceleration, bool to_the_pass) {
  const double start = t;
  Motion k[7] = {{v, acceleration(x, v, t)}};
  for (double h = 1e-3 * duration, done = 0; done < duration;) {
    h = std::min(h, duration - done);
    Motion end{x, v};
    for (int i = 1; i < 7; ++i) {
      double reach = 0;
      for (int j = 0; j < i; ++j) reach += rows[i][j];
      const Motion along = sum(rows[i], k, i);
      end = {x + h * along.x, v + h * along.v};
      k[i] = {end.v, acceleration(end.x, end.v, start + done + reach * h)};
    }
    const Motion off = sum(difference, k, 7);
    const double estimate = h * std::sqrt(std::max(dot(off.x, off.x), dot(off.v, off.v)));
    const bool reached = h == duration - done;
    const double step = h;
    h *= std::min(4.0, std::max(0.1, 0.85 * std::pow(tolerance / (estimate + 1e-30), 0.2)));
    if (estimate > tolerance) continue;
    if (to_the_pass && dot(end.x, end.v) > 0) return {done, step};
    x = end.x;
    v = end.v;
    k[0] = k[6];
    done = reached ? duration : done + step;
  }
  return {duration, 0};
}

inline void fly(Vec& x, Vec& v, double t, double duration, double tolerance,
                const Acceleration& acceleration) {
  fly_to(x, v, t, duration, tolerance, acceleration, false);
}

// The part of the step in which it turns, by the rule of false position, each time by one step.
inline double nearest(Vec x, Vec v, double t, double duration, double tolerance,
                      const Acceleration& acceleration) {
  const Stopped at = fly_to(x, v, t, duration, tolerance, acceleration, true);
  const auto slope_at = [&](double h) {
    Vec x_then = x, v_then = v;
    fly_to(x_then, v_then, t + at.done, h, tolerance, acceleration, false);
    return dot(x_then, v_then);
  };
  double low = 0, high = at.step, below = dot(x, v), above = slope_at(high), part = high;
  for (int n = 0; n < 12 && high - low > 1e-12 * duration; ++n) {
    part = low - below * (high - low) / (above - below);
    const double there = slope_at(part);
    if (there < 0) {
      low = part, below = there, above /= 2;
    } else {
      high = part, above = there, below /= 2;
    }
  }
  return t + at.done + part;
}
