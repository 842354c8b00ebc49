// SPDX-License-Identifier: MIT-0
/// @file
/// The lines that the page gives to copy, each within a function that its claims call.
#pragma once
#include <cmath>

#include "integrate/backward_euler.h"
#include "integrate/backward_euler_spring.h"
#include "integrate/bdf2.h"
#include "integrate/constant_acceleration.h"
#include "integrate/dopri5.h"
#include "integrate/linear_damping.h"
#include "integrate/rk4.h"
#include "integrate/sparse_system.h"
#include "integrate/spring_exact.h"
#include "integrate/stormer_verlet.h"
#include "integrate/symplectic_euler.h"
#include "integrate/velocity_verlet.h"
#include "integrate/yoshida4.h"
#include "shelf/fixed_step.h"

/// A jump.
template <class Vec, class Real>
void move_by_constant(Vec& x, Vec& v, double t, Real tick, const Vec& g) {
  // [constant]
  const auto gravity = [&](const Vec&, const Vec&, double) { return g; };
  integrate::constant_acceleration(x, v, t, tick, gravity);
  // [constant]
}

/// A leaf.
/// @param c  drag per mass [1/s]; above zero
template <class Vec, class Real>
void move_in_air(Vec& x, Vec& v, Real tick, const Vec& g, Real c) {
  // [air]
  const auto push = -std::expm1(-c * tick) / c;
  x = x + push * v + ((tick - push) / c) * g;
  v = std::exp(-c * tick) * v + push * g;
  // [air]
}

/// A camera.
/// @param target  where it is at the start of the tick
/// @param u  the velocity of the target
template <class Vec, class Real>
void move_on_spring(Vec& x, Vec& v, Real tick, const Vec& target, const Vec& u, Real omega,
                    Real zeta) {
  // [spring]
  const Vec lag = (2 * zeta / omega) * u;
  Vec way = x - target + lag;
  Vec rel = v - u;
  integrate::spring_exact(way, rel, tick, omega, zeta);
  x = target + tick * u - lag + way;
  v = rel + u;
  // [spring]
}

/// A body with contacts and joints.
template <class Vec, class Real, class Acceleration>
void move_undamped(Vec& x, Vec& v, double t, Real tick, int steps,
                   const Acceleration& acceleration) {
  // [undamped]
  const auto h = tick / steps;
  for (int n = 0; n < steps; ++n) {
    integrate::symplectic_euler(x, v, t + n * h, h, acceleration);
  }
  // [undamped]
}

/// A body with drag.
template <class Vec, class Real, class Acceleration>
void move_with_drag(Vec& x, Vec& v, double t, Real tick, int steps, Real c,
                    const Acceleration& acceleration) {
  // [drag]
  const auto h = tick / steps;
  for (int n = 0; n < steps; ++n) {
    // acceleration without the drag
    integrate::linear_damping_implicit_last(x, v, t + n * h, h, c, acceleration);
  }
  // [drag]
}

/// Two bodies with a damper between them.
/// @param axis  of length one, from the one to the other
/// @param accelerations  of both, by all forces but the damper
template <class Body, class Vec, class Real, class Accelerations>
void move_pair(Body& one, Body& two, const Vec& axis, Real d, Real tick, int steps,
               const Accelerations& accelerations) {
  // [between]
  const auto h = tick / steps;
  const auto light = 1 / one.m + 1 / two.m;
  for (int n = 0; n < steps; ++n) {
    // by all forces but the damper
    const auto [a1, a2] = accelerations(one, two);
    one.v = one.v + h * a1;
    two.v = two.v + h * a2;
    const auto fast = dot(two.v - one.v, axis);
    const auto left = fast / (1 + d * h * light);
    const Vec push = ((fast - left) / light) * axis;
    one.v = one.v + (1 / one.m) * push;
    two.v = two.v + (-1 / two.m) * push;
    one.x = one.x + h * one.v;
    two.x = two.x + h * two.v;
  }
  // [between]
}

/// What a rope of particles keeps from tick to tick.
/// @returns  the places one step ago
template <class Vec, class Real, class Acceleration>
Vec start_linked(const Vec& x, const Vec& v, double t, Real tick, int steps,
                 const Acceleration& acceleration) {
  // [links-once]
  // once, and kept from tick to tick
  const auto h = tick / steps;
  Vec last = integrate::stormer_verlet_start(x, v, t, h, acceleration);

  // [links-once]
  return last;
}

/// A rope of particles, whose links are put right after each step.
/// @param last  from start_linked()
template <class Vec, class Real, class Acceleration, class Links>
void move_linked(Vec& x, Vec& v, Vec& last, double t, Real h, int steps,
                 const Acceleration& acceleration, const Links& pull_links) {
  // [links]
  // every tick
  for (int n = 0; n < steps; ++n) {
    integrate::stormer_verlet(x, last, t + n * h, h, acceleration);
    pull_links(x);  // changes the velocity, too
  }
  v = integrate::stormer_verlet_velocity(x, last, h);  // of half a step ago
  // [links]
}

/// An orbit whose place counts.
template <class Vec, class Real, class Acceleration>
void move_for_ever(Vec& x, Vec& v, double t, Real tick, int steps,
                   const Acceleration& acceleration) {
  // [place]
  const auto h = tick / steps;
  Vec a = integrate::yoshida4_start(x, v, t, acceleration);  // once
  for (int n = 0; n < steps; ++n) {
    integrate::yoshida4(x, v, a, t + n * h, h, acceleration);
  }
  // [place]
}

/// An orbit of which only the shape counts.
template <class Vec, class Real, class Acceleration>
void move_in_shape(Vec& x, Vec& v, double t, Real tick, int steps,
                   const Acceleration& acceleration) {
  // [shape]
  const auto h = tick / steps;
  Vec a = integrate::velocity_verlet_start(x, v, t, acceleration);  // once
  for (int n = 0; n < steps; ++n) {
    integrate::velocity_verlet(x, v, a, t + n * h, h, acceleration);
  }
  // [shape]
}

/// The same in frames of any length, cut into steps of one length.
/// @param lengths  of the frames [s]
/// @returns  the time that the steps have reached [s]
template <class Vec, class Lengths, class Acceleration>
double move_in_frames(Vec& x, Vec& v, double tick, int steps, const Lengths& lengths,
                      const Acceleration& acceleration) {
  // [frames]
  shelf::FixedStep<> clock{tick / steps};                             // once
  Vec a = integrate::velocity_verlet_start(x, v, 0.0, acceleration);  // once
  const auto step = [&](double now) {
    integrate::velocity_verlet(x, v, a, now, clock.h, acceleration);
  };
  for (const double length : lengths) clock.frame(length, step);
  // [frames]
  return clock.time();
}

/// What is watched closely.
template <class Vec, class Real, class Acceleration>
void move_closely(Vec& x, Vec& v, double t, Real tick, int steps,
                  const Acceleration& acceleration) {
  // [closely]
  const auto h = tick / steps;
  for (int n = 0; n < steps; ++n) {
    integrate::rk4(x, v, t + n * h, h, acceleration);
  }
  // [closely]
}

/// To a tolerance.
/// @param now  when it is to be seen [s]
template <class Vec, class Real, class Acceleration>
void move_within(Vec& x, Vec& v, double t, Real tick, double now, const Acceleration& acceleration,
                 Real tolerance) {
  // [tolerance]
  const auto size = [](const Vec& error) { return length(error); };
  auto path = integrate::dopri5_path(x, v, t, tick, acceleration);  // once
  if (integrate::dopri5_adaptive(path, now, acceleration, size, tolerance)) {
    x = path.position(now), v = path.velocity(now);
  }
  // [tolerance]
}

/// A stiff spring to a fixed place, among other forces.
template <class Vec, class Real, class Acceleration>
void move_stiff(Vec& x, Vec& v, double t, Real tick, int steps, const Vec& anchor, Real omega,
                Real zeta, const Acceleration& acceleration) {
  // [stiff]
  const auto h = tick / steps;
  for (int n = 0; n < steps; ++n) {
    // acceleration without the spring
    v = v + h * acceleration(x, v, t + n * h);
    Vec way = x - anchor;
    integrate::backward_euler_spring(way, v, h, omega, zeta);
    x = anchor + way;
  }
  // [stiff]
}

/// Many stiff springs.
template <class Vec, class Acceleration, class Jacobian>
bool move_net(Vec& x, Vec& v, double t, double tick, const Acceleration& acceleration,
              Jacobian jacobian) {
  // [net]
  integrate::SparseSystem<decltype(jacobian)> system(jacobian);  // once
  bool solved = integrate::backward_euler(x, v, t, tick, acceleration, system);
  // [net]
  return solved;
}

/// Many stiff springs, and slow swings among them.
template <class Vec, class Acceleration, class Jacobian>
bool move_slow(Vec& x, Vec& v, double t, double tick, int ticks, const Acceleration& acceleration,
               Jacobian jacobian) {
  // [slow]
  integrate::SparseSystem<decltype(jacobian)> system(jacobian);    // once
  auto last = integrate::bdf2_start(x, v, t, tick, acceleration);  // once
  bool solved = true;
  for (int n = 0; n < ticks && solved; ++n) {  // till something hits it
    solved = integrate::bdf2(x, v, last, t + n * tick, tick, tick, acceleration, system);
  }
  // [slow]
  return solved;
}
