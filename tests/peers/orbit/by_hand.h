// SPDX-License-Identifier: MIT-0
// The formulas written out for this one scene, in plain numbers: what there is to reach.
#pragma once
#include "orbit/state.h"

namespace orbit::by_hand {

inline State euler(State s, long steps, double h) {
  auto [x, y, vx, vy] = s;
  for (long n = 0; n < steps; ++n) {
    const double p = pull(x * x + y * y);
    const double ax = p * x;
    const double ay = p * y;
    x += h * vx;
    y += h * vy;
    vx += h * ax;
    vy += h * ay;
  }
  return end_at(x, y, vx, vy);
}

inline State symplectic_euler(State s, long steps, double h) {
  auto [x, y, vx, vy] = s;
  for (long n = 0; n < steps; ++n) {
    const double p = pull(x * x + y * y);
    vx += h * (p * x);
    vy += h * (p * y);
    x += h * vx;
    y += h * vy;
  }
  return end_at(x, y, vx, vy);
}

inline State velocity_verlet(State s, long steps, double h) {
  auto [x, y, vx, vy] = s;
  double p = pull(x * x + y * y);
  double ax = p * x;
  double ay = p * y;
  for (long n = 0; n < steps; ++n) {
    const double half_x = vx + h / 2 * ax;
    const double half_y = vy + h / 2 * ay;
    x += h * half_x;
    y += h * half_y;
    p = pull(x * x + y * y);
    ax = p * x;
    ay = p * y;
    vx = half_x + h / 2 * ax;
    vy = half_y + h / 2 * ay;
  }
  return end_at(x, y, vx, vy);
}

inline State rk4(State s, long steps, double h) {
  auto [x, y, vx, vy] = s;
  for (long n = 0; n < steps; ++n) {
    const double p1 = pull(x * x + y * y);
    const double ax1 = p1 * x, ay1 = p1 * y;
    const double vx2 = vx + h / 2 * ax1, vy2 = vy + h / 2 * ay1;
    const double x2 = x + h / 2 * vx, y2 = y + h / 2 * vy;
    const double p2 = pull(x2 * x2 + y2 * y2);
    const double ax2 = p2 * x2, ay2 = p2 * y2;
    const double vx3 = vx + h / 2 * ax2, vy3 = vy + h / 2 * ay2;
    const double x3 = x + h / 2 * vx2, y3 = y + h / 2 * vy2;
    const double p3 = pull(x3 * x3 + y3 * y3);
    const double ax3 = p3 * x3, ay3 = p3 * y3;
    const double vx4 = vx + h * ax3, vy4 = vy + h * ay3;
    const double x4 = x + h * vx3, y4 = y + h * vy3;
    const double p4 = pull(x4 * x4 + y4 * y4);
    const double ax4 = p4 * x4, ay4 = p4 * y4;
    x += h / 6 * (vx + 2 * (vx2 + vx3) + vx4);
    y += h / 6 * (vy + 2 * (vy2 + vy3) + vy4);
    vx += h / 6 * (ax1 + 2 * (ax2 + ax3) + ax4);
    vy += h / 6 * (ay1 + 2 * (ay2 + ay3) + ay4);
  }
  return end_at(x, y, vx, vy);
}

/// Position and velocity packed into one vector of four, as books on differential equations have
/// it: y' = f(t, y).
template <class Vector4>
State rk4_packed(State s, long steps, double h) {
  const auto f = [](const Vector4& y) -> Vector4 {
    const double p = pull(y[0] * y[0] + y[1] * y[1]);
    return Vector4(y[2], y[3], p * y[0], p * y[1]);
  };
  Vector4 y(s.x, s.y, s.vx, s.vy);
  for (long n = 0; n < steps; ++n) {
    const Vector4 k1 = f(y);
    const Vector4 k2 = f(y + h / 2 * k1);
    const Vector4 k3 = f(y + h / 2 * k2);
    const Vector4 k4 = f(y + h * k3);
    y += h / 6 * (k1 + 2 * (k2 + k3) + k4);
  }
  return end_at(y[0], y[1], y[2], y[3]);
}

}  // namespace orbit::by_hand
