// SPDX-License-Identifier: MIT-0
// Euler's relatives that are no Runge-Kutta methods, each by what it does to the positions.
#pragma once
#include <vector>

#include "measure/methods.h"
#include "problem.h"

namespace textbook {

// Galileo's rule: the distance is that of the mean of both velocities.
inline std::vector<State> steps(measure::ConstantAcceleration, const Force& force,
                                const State& start, Real h, int count) {
  std::vector<State> states;
  State s = start;
  for (int n = 0; n < count; ++n) {
    const Real faster = s.v + h * force(s.x, s.v, n * h);
    s = {s.x + h * (s.v + faster) / 2, faster};
    states.push_back(s);
  }
  return states;
}

// The step adds h v + h^2 a, and the velocity is the distance over the time.
inline std::vector<State> steps(measure::SymplecticEuler, const Force& force, const State& start,
                                Real h, int count) {
  std::vector<State> states;
  State s = start;
  for (int n = 0; n < count; ++n) {
    const Real next = s.x + h * s.v + h * h * force(s.x, s.v, n * h);
    s = {next, (next - s.x) / h};
    states.push_back(s);
  }
  return states;
}

// The same with the positions one step ahead: the velocity is the distance still to go.
inline std::vector<State> steps(measure::SymplecticEulerPositionFirst, const Force& force,
                                const State& start, Real h, int count) {
  std::vector<State> states;
  Real x = start.x;
  Real next = x + h * start.v;
  for (int n = 0; n < count; ++n) {
    const Real after = 2 * next - x + h * h * force(next, (next - x) / h, (n + 1) * h);
    x = next;
    next = after;
    states.push_back({x, (next - x) / h});
  }
  return states;
}

}  // namespace textbook
