// SPDX-License-Identifier: MIT-0
// The classical method of Runge and Kutta, to compute references.
#pragma once
#include "scenes/state.h"

template <class Scene, class Vec>
scenes::State<Vec> runge_kutta(const Scene& scene, scenes::State<Vec> s, double duration,
                               int steps) {
  const double h = duration / steps;
  for (int n = 0; n < steps; ++n) {
    const double t = n * h;
    const Vec k1 = scene(s.x, s.v, t);
    const Vec v2 = s.v + (h / 2) * k1;
    const Vec k2 = scene(Vec(s.x + (h / 2) * s.v), v2, t + h / 2);
    const Vec v3 = s.v + (h / 2) * k2;
    const Vec k3 = scene(Vec(s.x + (h / 2) * v2), v3, t + h / 2);
    const Vec v4 = s.v + h * k3;
    const Vec k4 = scene(Vec(s.x + h * v3), v4, t + h);
    s.x = s.x + (h / 6) * (s.v + 2 * v2 + 2 * v3 + v4);
    s.v = s.v + (h / 6) * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return s;
}
