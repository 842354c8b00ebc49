// SPDX-License-Identifier: MIT-0
// The headers of this book, on several types of vector.
#pragma once
#include <Eigen/Core>

#include "integrate/euler.h"
#include "integrate/rk4.h"
#include "integrate/symplectic_euler.h"
#include "integrate/velocity_verlet.h"
#include "orbit/state.h"

namespace orbit {

/// All that a header asks of a vector.
struct Pair {
  double x, y;
  friend constexpr Pair operator+(Pair a, Pair b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Pair operator*(double s, Pair a) { return {s * a.x, s * a.y}; }
};

struct Gravity {
  Pair operator()(const Pair& x, const Pair&, double) const {
    return pull(x.x * x.x + x.y * x.y) * x;
  }
  template <class Vec>
  Vec operator()(const Vec& x, const Vec&, double) const {
    return pull(x.squaredNorm()) * x;
  }
};

}  // namespace orbit

namespace orbit::with_headers {

inline void set(Pair& p, double x, double y) {
  p = {x, y};
}
template <class Vec>
void set(Vec& p, double x, double y) {
  p = Eigen::Vector2d(x, y);
}

inline State both(Pair x, Pair v) {
  return end_at(x.x, x.y, v.x, v.y);
}
template <class Vec>
State both(const Vec& x, const Vec& v) {
  return end_at(x[0], x[1], v[0], v[1]);
}

/// The loop that a reader writes around a method without memory.
template <class Vec, class Step, class Acceleration>
auto loop(Step step, Acceleration acceleration) {
  return [step, acceleration](State s, long steps, double h) {
    Vec x, v;
    set(x, s.x, s.y);
    set(v, s.vx, s.vy);
    for (long n = 0; n < steps; ++n) step(x, v, double(n) * h, h, acceleration);
    return both(x, v);
  };
}

template <class Vec, class Acceleration = Gravity>
auto euler(Acceleration acceleration = {}) {
  return loop<Vec>([](auto&&... all) { integrate::euler(all...); }, acceleration);
}

template <class Vec, class Acceleration = Gravity>
auto symplectic_euler(Acceleration acceleration = {}) {
  return loop<Vec>([](auto&&... all) { integrate::symplectic_euler(all...); }, acceleration);
}

template <class Vec, class Acceleration = Gravity>
auto rk4(Acceleration acceleration = {}) {
  return loop<Vec>([](auto&&... all) { integrate::rk4(all...); }, acceleration);
}

template <class Vec, class Acceleration = Gravity>
auto velocity_verlet(Acceleration acceleration = {}) {
  return [acceleration](State s, long steps, double h) {
    Vec x, v;
    set(x, s.x, s.y);
    set(v, s.vx, s.vy);
    Vec a = integrate::velocity_verlet_start(x, v, 0.0, acceleration);
    for (long n = 0; n < steps; ++n) {
      integrate::velocity_verlet(x, v, a, double(n) * h, h, acceleration);
    }
    return both(x, v);
  };
}

}  // namespace orbit::with_headers
