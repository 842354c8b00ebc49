// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The method of order five, six evaluations a step, in steps of so many paces.
struct Shuttle {
  Vec x, v;
  double t;
};

inline Shuttle dopri5(const Shuttle& s, double h, const Acceleration& acceleration) {
  constexpr double b[6][5] = {
      {},
      {1.0 / 5},
      {3.0 / 40, 9.0 / 40},
      {44.0 / 45, -56.0 / 15, 32.0 / 9},
      {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
      {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656}};
  constexpr double c[6] = {0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1};
  constexpr double w[6] = {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84};
  Vec dx[6], dv[6];
  Shuttle end = s;
  for (int i = 0; i < 6; ++i) {
    Vec x = s.x, v = s.v;
    for (int j = 0; j < i; ++j) {
      x += h * b[i][j] * dx[j];
      v += h * b[i][j] * dv[j];
    }
    dx[i] = v;
    dv[i] = acceleration(x, v, s.t + c[i] * h);
    end.x += h * w[i] * dx[i];
    end.v += h * w[i] * dv[i];
  }
  end.t += h;
  return end;
}

inline std::pair<Shuttle, int> fly_by(double paces, Shuttle s, double end,
                                      const Acceleration& acceleration) {
  int steps = 0;
  while (end - s.t > 1e-12) {
    s = dopri5(s, std::min(paces * std::pow(length(s.x), 1.5), end - s.t), acceleration);
    ++steps;
  }
  return {s, steps};
}

inline void fly(Vec& x, Vec& v, double t, double seconds, const Acceleration& acceleration) {
  const int taken = fly_by(0.3, {x, v, t}, t + seconds, acceleration).second;
  const double paces = 0.3 * taken / (0.9 * (1200 / 6 - taken));
  const Shuttle there = fly_by(paces, {x, v, t}, t + seconds, acceleration).first;
  x = there.x;
  v = there.v;
}
