// SPDX-License-Identifier: MIT-0
// The methods of Verlet's family, each in another of its forms than the header has: what the header
// writes with positions stands here with velocities, and the other way round.
#pragma once
#include <cmath>
#include <vector>

#include "measure/methods.h"
#include "problem.h"

namespace textbook {

// Position Verlet, summed: the distance of a step is that of the step before and h^2 a.
inline std::vector<State> steps(measure::StormerVerlet, const Force& force, const State& start,
                                Real h, int count) {
  std::vector<State> states;
  Real x = start.x;
  Real distance = h * start.v - h * h / 2 * force(start.x, start.v, 0);
  for (int n = 0; n < count; ++n) {
    distance += h * h * force(x, distance / h, n * h);
    x += distance;
    states.push_back({x, distance / h});
  }
  return states;
}

inline std::vector<State> steps(measure::StormerVerletUneven, const Force& force,
                                const State& start, Real h, int count) {
  return steps(measure::StormerVerlet(), force, start, h, count);
}

inline std::vector<State> steps(measure::StormerVerletDistance, const Force& force,
                                const State& start, Real h, int count) {
  return steps(measure::StormerVerlet(), force, start, h, count);
}

// Kicks from one half step to the next; the force sees the velocity of now, by the last kick.
inline std::vector<State> steps(measure::StormerVerletCarried, const Force& force,
                                const State& start, Real h, int count) {
  std::vector<State> states;
  Real x = start.x;
  Real kick = h * force(start.x, start.v, 0);
  Real half = start.v - kick / 2;
  for (int n = 0; n < count; ++n) {
    kick = h * force(x, half + kick / 2, n * h);
    half += kick;
    x += h * half;
    states.push_back({x, half + kick / 2});
  }
  return states;
}

// Leapfrog in positions alone: the second difference is h^2 a.
inline std::vector<State> steps(measure::Leapfrog, const Force& force, const State& start, Real h,
                                int count) {
  std::vector<State> states;
  Real before = start.x - h * (start.v - h / 2 * force(start.x, start.v, 0));
  Real x = start.x;
  for (int n = 0; n < count; ++n) {
    const Real next = 2 * x - before + h * h * force(x, (x - before) / h, n * h);
    before = x;
    x = next;
    const Real half = (x - before) / h;
    states.push_back({x, half + h / 2 * force(x, half, (n + 1) * h)});
  }
  return states;
}

// Leapfrog on the places at the middles of the steps; what stands at their ends is the mean of two.
inline std::vector<State> steps(measure::LeapfrogDrift, const Force& force, const State& start,
                                Real h, int count) {
  std::vector<State> states;
  Real before = start.x - h * start.v / 2;
  Real middle = start.x + h * start.v / 2;
  for (int n = 0; n < count; ++n) {
    const Real a = force(middle, (middle - before) / h, (n + 0.5L) * h);
    const Real next = 2 * middle - before + h * h * a;
    before = middle;
    middle = next;
    states.push_back({(before + middle) / 2, (middle - before) / h});
  }
  return states;
}

// A parabola to the end, and there the mean of both accelerations.
inline void velocity_verlet(State& s, Real& a, const Force& force, Real t, Real h) {
  const Real before = a;
  s.x += h * s.v + h * h * before / 2;
  a = force(s.x, s.v + h * before, t + h);
  s.v += h * (before + a) / 2;
}

inline std::vector<State> steps(measure::VelocityVerlet, const Force& force, const State& start,
                                Real h, int count) {
  std::vector<State> states;
  State s = start;
  Real a = force(s.x, s.v, 0);
  for (int n = 0; n < count; ++n) {
    velocity_verlet(s, a, force, n * h, h);
    states.push_back(s);
  }
  return states;
}

// Three Verlet steps, the middle one back, whose cubes cancel: 2 w^3 + (1 - 2 w)^3 = 0.
inline std::vector<State> steps(measure::Yoshida4, const Force& force, const State& start, Real h,
                                int count) {
  const Real root = std::cbrt(2.0L);
  const Real weights[] = {1 / (2 - root), -root / (2 - root), 1 / (2 - root)};
  std::vector<State> states;
  State s = start;
  Real a = force(s.x, s.v, 0);
  for (int n = 0; n < count; ++n) {
    Real t = n * h;
    for (const Real weight : weights) {
      velocity_verlet(s, a, force, t, weight * h);
      t += weight * h;
    }
    states.push_back(s);
  }
  return states;
}

}  // namespace textbook
