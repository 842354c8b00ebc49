// SPDX-License-Identifier: MIT-0
// Boost.odeint, on its own recommendation for small states (std::array) and on Eigen's vectors.
#pragma once
#include <Eigen/Core>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <boost/numeric/odeint/external/eigen/eigen.hpp>
#include <functional>
#include <utility>

#include "orbit/state.h"

namespace orbit::with_odeint {

namespace odeint = boost::numeric::odeint;

/// Euler and the Runge-Kutta methods, on position and velocity in one state of four numbers.
template <class Stepper>
State first_order(State s, long steps, double h) {
  using Four = typename Stepper::state_type;
  const auto f = [](const Four& y, Four& slope, double) {
    const double p = pull(y[0] * y[0] + y[1] * y[1]);
    slope[0] = y[2];
    slope[1] = y[3];
    slope[2] = p * y[0];
    slope[3] = p * y[1];
  };
  Stepper stepper;
  Four y{s.x, s.y, s.vx, s.vy};
  for (long n = 0; n < steps; ++n) stepper.do_step(f, y, double(n) * h, h);
  return end_at(y[0], y[1], y[2], y[3]);
}

/// Its symplectic_euler moves the position first. Told that the velocity is the position, and the
/// other way round, it moves the velocity first, as the other rows do.
template <class Two>
State symplectic_euler(State s, long steps, double h) {
  const auto acceleration = [](const Two& x, Two& a) {
    const double p = pull(x[0] * x[0] + x[1] * x[1]);
    a[0] = p * x[0];
    a[1] = p * x[1];
  };
  const auto velocity = [](const Two& v, Two& slope) { slope = v; };
  odeint::symplectic_euler<Two> stepper;
  Two x{s.x, s.y}, v{s.vx, s.vy};
  const auto slopes = std::make_pair(acceleration, velocity);
  for (long n = 0; n < steps; ++n) stepper.do_step(slopes, v, x, double(n) * h, h);
  return end_at(x[0], x[1], v[0], v[1]);
}

template <class Two>
State velocity_verlet(State s, long steps, double h) {
  const auto acceleration = [](const Two& x, const Two&, Two& a, double) {
    const double p = pull(x[0] * x[0] + x[1] * x[1]);
    a[0] = p * x[0];
    a[1] = p * x[1];
  };
  odeint::velocity_verlet<Two> stepper;
  Two x{s.x, s.y}, v{s.vx, s.vy};
  auto both = std::make_pair(std::ref(x), std::ref(v));
  for (long n = 0; n < steps; ++n) stepper.do_step(acceleration, both, double(n) * h, h);
  return end_at(x[0], x[1], v[0], v[1]);
}

}  // namespace orbit::with_odeint
