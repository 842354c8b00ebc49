// SPDX-License-Identifier: MIT-0
/// @file
/// The lines that the page gives to copy, each within a function that its claims call.
#pragma once

#include "frames/fixed_step.h"
#include "integrate/backward_euler.h"
#include "integrate/backward_euler_spring.h"
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

/// A jump.
template <class Vec>
void move_by_constant(Vec& x, Vec& v, double t, double tick, const Vec& g) {
  // [constant]
  const auto gravity = [&](const Vec&, const Vec&, double) { return g; };
  integrate::constant_acceleration(x, v, t, tick, gravity);
  // [constant]
}

/// A leaf.
template <class Vec>
void move_in_air(Vec& x, Vec& v, double t, double tick, const Vec& g, double c) {
  // [air]
  const auto gravity = [&](const Vec&, const Vec&, double) { return g; };
  integrate::linear_damping_exact(x, v, t, tick, c, gravity);
  // [air]
}

/// A camera.
template <class Vec>
void move_on_spring(Vec& x, Vec& v, double tick, const Vec& target, double omega, double zeta) {
  // [spring]
  Vec way = x - target;
  integrate::spring_exact(way, v, tick, omega, zeta);
  x = target + way;
  // [spring]
}

/// A body with contacts and joints.
template <class Vec, class Forces>
void move_undamped(Vec& x, Vec& v, double t, double tick, int steps, const Forces& forces) {
  // [undamped]
  const double h = tick / steps;
  for (int n = 0; n < steps; ++n) {
    integrate::symplectic_euler(x, v, t + n * h, h, forces);
  }
  // [undamped]
}

/// A body with drag.
template <class Vec, class Forces>
void move_with_drag(Vec& x, Vec& v, double t, double tick, int steps, double c,
                    const Forces& forces) {
  // [drag]
  const double h = tick / steps;
  for (int n = 0; n < steps; ++n) {  // forces: all but the drag
    integrate::linear_damping_implicit_last(x, v, t + n * h, h, c, forces);
  }
  // [drag]
}

/// Two bodies with a damper between them.
/// @param axis  of length one, from the one to the other
template <class Body, class Vec>
void move_pair(Body& one, Body& two, const Vec& axis, double d, double tick, int steps,
               const Vec& a1, const Vec& a2) {
  // [between]
  const double h = tick / steps;
  const double light = 1 / one.m + 1 / two.m;
  for (int n = 0; n < steps; ++n) {
    one.v = one.v + h * a1;  // but the damper's
    two.v = two.v + h * a2;
    const double fast = dot(two.v - one.v, axis);
    const double left = fast / (1 + d * h * light);
    const Vec push = ((fast - left) / light) * axis;
    one.v = one.v + (1 / one.m) * push;
    two.v = two.v + (-1 / two.m) * push;
    one.x = one.x + h * one.v;
    two.x = two.x + h * two.v;
  }
  // [between]
}

/// A rope of particles, whose links are put right after each step.
template <class Vec, class Forces, class Links>
void move_linked(Vec& x, Vec& v, double t, double tick, int steps, const Forces& forces,
                 const Links& pull_links) {
  // [links]
  const double h = tick / steps;
  Vec before = integrate::stormer_verlet_start(x, v, t, h, forces);  // once
  for (int n = 0; n < steps; ++n) {
    integrate::stormer_verlet(x, before, t + n * h, h, forces);
    pull_links(x);  // changes the velocity, too
  }
  // [links]
  v = integrate::stormer_verlet_velocity(x, before, h);
}

/// An orbit whose place counts.
template <class Vec, class Forces>
void move_for_ever(Vec& x, Vec& v, double t, double tick, int steps, const Forces& forces) {
  // [place]
  const double h = tick / steps;
  Vec a = integrate::yoshida4_start(x, v, t, forces);  // once
  for (int n = 0; n < steps; ++n) {
    integrate::yoshida4(x, v, a, t + n * h, h, forces);
  }
  // [place]
}

/// An orbit of which only the shape counts.
template <class Vec, class Forces>
void move_in_shape(Vec& x, Vec& v, double t, double tick, int steps, const Forces& forces) {
  // [shape]
  const double h = tick / steps;
  Vec a = integrate::velocity_verlet_start(x, v, t, forces);  // once
  for (int n = 0; n < steps; ++n) {
    integrate::velocity_verlet(x, v, a, t + n * h, h, forces);
  }
  // [shape]
}

/// The same in frames of any length, cut into steps of one length.
/// @param lengths  of the frames [s]
/// @returns  the time that the steps have reached [s]
template <class Vec, class Lengths, class Forces>
double move_in_frames(Vec& x, Vec& v, double tick, int steps, const Lengths& lengths,
                      const Forces& forces) {
  // [frames]
  frames::FixedStep<> clock{tick / steps};
  Vec a = integrate::velocity_verlet_start(x, v, 0.0, forces);
  for (const double length : lengths) {  // of the frames, in seconds
    clock.frame(length, [&](double t) {
      integrate::velocity_verlet(x, v, a, t, clock.h, forces);
    });
  }
  // [frames]
  return double(clock.steps) * clock.h;
}

/// What is watched closely.
template <class Vec, class Forces>
void move_closely(Vec& x, Vec& v, double t, double tick, int steps, const Forces& forces) {
  // [closely]
  const double h = tick / steps;
  for (int n = 0; n < steps; ++n) {
    integrate::rk4(x, v, t + n * h, h, forces);
  }
  // [closely]
}

/// To a tolerance; `next` is kept from call to call.
template <class Vec, class Forces>
bool move_within(Vec& x, Vec& v, double t, double duration, double& next, const Forces& forces,
                 double tolerance) {
  // [tolerance]
  const auto size = [](const Vec& error) { return length(error); };
  const bool arrived = integrate::dopri5_adaptive(x, v, t, duration, next, forces, size, tolerance);
  // [tolerance]
  return arrived;
}

/// A stiff spring to a fixed place, among other forces.
template <class Vec, class Forces>
void move_stiff(Vec& x, Vec& v, double t, double tick, int steps, const Vec& anchor, double omega,
                double zeta, const Forces& forces) {
  // [stiff]
  const double h = tick / steps;
  for (int n = 0; n < steps; ++n) {
    v = v + h * forces(x, v, t + n * h);  // all but the spring
    Vec way = x - anchor;
    integrate::backward_euler_spring(way, v, h, omega, zeta);
    x = anchor + way;
  }
  // [stiff]
}

/// Many stiff springs.
template <class Vec, class Forces, class Jacobian>
bool move_net(Vec& x, Vec& v, double t, double tick, const Forces& forces, Jacobian jacobian) {
  // [net]
  integrate::SparseSystem<decltype(jacobian)> system(jacobian);  // once
  const bool solved = integrate::backward_euler(x, v, t, tick, forces, system);
  // [net]
  return solved;
}
