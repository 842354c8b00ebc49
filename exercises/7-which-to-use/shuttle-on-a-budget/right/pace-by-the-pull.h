// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The pace from the pull itself, so that nothing need be known of planets: the root of r / a. Steps
// shorten within a step of RK4, too, since the clock runs with the pace.
struct Shuttle {
  Vec x, v;
  double t = 0;
};

inline Shuttle operator+(const Shuttle& a, const Shuttle& b) {
  return {a.x + b.x, a.v + b.v, a.t + b.t};
}
inline Shuttle operator*(double s, const Shuttle& a) {
  return {s * a.x, s * a.v, s * a.t};
}

inline Shuttle rate(const Shuttle& s, const Acceleration& acceleration) {
  const Vec a = acceleration(s.x, s.v, s.t);
  return std::sqrt(length(s.x) / length(a)) * Shuttle{s.v, a, 1};
}

inline Shuttle rk4(const Shuttle& s, double h, const Acceleration& acceleration) {
  const Shuttle k1 = rate(s, acceleration), k2 = rate(s + h / 2 * k1, acceleration);
  const Shuttle k3 = rate(s + h / 2 * k2, acceleration), k4 = rate(s + h * k3, acceleration);
  return s + h / 6 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
}

inline Shuttle plain_rk4(const Shuttle& s, double h, const Acceleration& acceleration) {
  const auto plain = [&](const Shuttle& at) {
    return Shuttle{at.v, acceleration(at.x, at.v, at.t), 1};
  };
  const Shuttle k1 = plain(s), k2 = plain(s + h / 2 * k1), k3 = plain(s + h / 2 * k2);
  return s + h / 6 * (k1 + 2.0 * k2 + 2.0 * k3 + plain(s + h * k3));
}

inline void fly(Vec& x, Vec& v, double t, double seconds, const Acceleration& acceleration) {
  const double end = t + seconds, rough = 0.25;
  Shuttle scout{x, v, t}, s = scout;
  int taken = 0;
  for (; scout.t < end; ++taken) scout = rk4(scout, rough, acceleration);
  const double h = rough * taken / (0.97 * (1200 / 4 - taken));
  for (;;) {
    const Shuttle next = rk4(s, h, acceleration);
    if (next.t > end) break;
    s = next;
  }
  s = plain_rk4(s, end - s.t, acceleration);
  x = s.x;
  v = s.v;
}
