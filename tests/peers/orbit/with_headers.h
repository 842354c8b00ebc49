// SPDX-License-Identifier: MIT-0
// The headers of this book, on several types of vector.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <type_traits>
#include <vector>

#include "integrate/dopri5.h"
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

/// The same behind a pointer.
struct AnyGravity {
  using Vec = Eigen::Vector2d;
  std::function<Vec(const Vec&, const Vec&, double)> pulls = Gravity();
  Vec operator()(const Vec& x, const Vec& v, double t) const { return pulls(x, v, t); }
};

}  // namespace orbit

namespace orbit::with_headers {

template <class Vec>
Vec both(double x, double y) {
  if constexpr (std::is_same_v<Vec, Pair>) {
    return {x, y};
  } else {
    return Eigen::Vector2d(x, y);
  }
}

inline State both(Pair x, Pair v) {
  return {x.x, x.y, v.x, v.y};
}
template <class Vec>
State both(const Vec& x, const Vec& v) {
  return {x[0], x[1], v[0], v[1]};
}

/// A planet, and what pulls it.
template <class SomeVec, class Acceleration>
struct Planet {
  using Vec = SomeVec;
  using Shared = Acceleration;
  Vec x, v;
  explicit Planet(State s) : x(both<Vec>(s.x, s.y)), v(both<Vec>(s.vx, s.vy)) {}
  Planet(const Vec& from, const Vec& speed) : x(from), v(speed) {}
  State state() const { return both(x, v); }
};

template <class Vec, class Acceleration = Gravity>
struct SymplecticEuler : Planet<Vec, Acceleration> {
  using Planet<Vec, Acceleration>::Planet;
  void step(const Acceleration& acceleration, double t, double h) {
    integrate::symplectic_euler(this->x, this->v, t, h, acceleration);
  }
};

template <class Vec, class Acceleration = Gravity>
struct Rk4 : Planet<Vec, Acceleration> {
  using Planet<Vec, Acceleration>::Planet;
  void step(const Acceleration& acceleration, double t, double h) {
    integrate::rk4(this->x, this->v, t, h, acceleration);
  }
};

template <class Vec, class Acceleration = Gravity>
struct VelocityVerlet : Planet<Vec, Acceleration> {
  using Planet<Vec, Acceleration>::Planet;
  Vec a = integrate::velocity_verlet_start(this->x, this->v, 0.0, Acceleration());
  void step(const Acceleration& acceleration, double t, double h) {
    integrate::velocity_verlet(this->x, this->v, a, t, h, acceleration);
  }
};

template <class Vec, class Acceleration = Gravity>
struct Dopri5 : Planet<Vec, Acceleration> {
  using Planet<Vec, Acceleration>::Planet;
  Vec a = integrate::dopri5_start(this->x, this->v, 0.0, Acceleration());
  void step(const Acceleration& acceleration, double t, double h) {
    integrate::dopri5(this->x, this->v, a, t, h, acceleration);
  }
};

/// The positions of all planets as one Vec, a column each.
template <std::size_t count, template <class, class> class Method>
std::vector<State> whole(const std::vector<State>& from, long steps, double h) {
  using All = Eigen::Matrix<double, 2, int(count)>;
  struct Pull {
    All operator()(const All& x, const All&, double) const {
      All a;
      for (long i = 0; i < a.cols(); ++i) a.col(i) = pull(x.col(i).squaredNorm()) * x.col(i);
      return a;
    }
  };
  All x, v;
  for (std::size_t i = 0; i < count; ++i) {
    x.col(long(i)) << from[i].x, from[i].y;
    v.col(long(i)) << from[i].vx, from[i].vy;
  }
  Method<All, Pull> all(x, v);
  for (long n = 0; n < steps; ++n) all.step(Pull(), double(n) * h, h);
  std::vector<State> end;
  for (long i = 0; i < x.cols(); ++i) end.push_back(both(all.x.col(i), all.v.col(i)));
  return end;
}

}  // namespace orbit::with_headers
