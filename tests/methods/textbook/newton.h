// SPDX-License-Identifier: MIT-0
// The implicit methods with a single solve: one step of Newton's method for both unknowns at once,
// on the defect of the implicit formula.
#pragma once
#include <vector>

#include "runge_kutta.h"

namespace textbook {

// Solves for two unknowns by Cramer's rule, where the derivative of the defect by each of them is a
// column; by central differences of order 8, exact for a polynomial up to that degree.
template <class Defect>
Pair solved(const Defect& defect, const Pair& z) {
  constexpr Real weights[] = {4 / 5.0L, -1 / 5.0L, 4 / 105.0L, -1 / 280.0L};
  constexpr Real apart = 0.125L;
  Pair by_position{0, 0}, by_velocity{0, 0};
  for (int n = 1; n <= 4; ++n) {
    const Real far = n * apart, weight = weights[n - 1] / apart;
    by_position += weight * (defect({z[0] + far, z[1]}) - defect({z[0] - far, z[1]}));
    by_velocity += weight * (defect({z[0], z[1] + far}) - defect({z[0], z[1] - far}));
  }
  const auto area = [](const Pair& p, const Pair& q) { return p[0] * q[1] - p[1] * q[0]; };
  const Pair right = defect(z);
  const Real whole = area(by_position, by_velocity);
  return {area(right, by_velocity) / whole, area(by_position, right) / whole};
}

// Newton's method begins where the velocity of the start leads to, with that velocity.
template <class Defect>
Pair newton_step(const Defect& defect, const Pair& z, Real h) {
  const Pair guess{z[0] + h * z[1], z[1]};
  return guess - solved(defect, guess);
}

inline std::vector<State> steps(measure::BackwardEuler, const Force& force, const State& start,
                                Real h, int count) {
  std::vector<State> states;
  Pair z{start.x, start.v};
  for (int n = 0; n < count; ++n) {
    const auto defect = [&](const Pair& end) -> Pair {
      return end - z - h * slope(force, end, (n + 1) * h);
    };
    z = newton_step(defect, z, h);
    states.push_back({z[0], z[1]});
  }
  return states;
}

inline std::vector<State> steps(measure::Trapezoid, const Force& force, const State& start, Real h,
                                int count) {
  std::vector<State> states;
  Pair z{start.x, start.v};
  for (int n = 0; n < count; ++n) {
    const auto defect = [&](const Pair& end) -> Pair {
      return end - z - h / 2 * (slope(force, z, n * h) + slope(force, end, (n + 1) * h));
    };
    z = newton_step(defect, z, h);
    states.push_back({z[0], z[1]});
  }
  return states;
}

// The end from which a parabola through it and the last two states has the slope that the force
// asks for there. The first step has a third of the slope of its start and two thirds of its end's.
template <class Solve>
std::vector<State> bdf2_steps(const Force& force, const State& start, Real h, int count,
                              Solve solve) {
  std::vector<State> states;
  Pair before, z{start.x, start.v};
  for (int n = 0; n < count; ++n) {
    const auto defect = [&](const Pair& end) -> Pair {
      const Pair wanted = h * slope(force, end, (n + 1) * h);
      if (n == 0) return end - z - h / 3 * slope(force, z, 0) - 2 * wanted / 3;
      return (3 * end - 4 * z + before) / 2 - wanted;
    };
    const Pair from = n == 0 ? Pair(z + h / 3 * slope(force, z, 0)) : Pair((4 * z - before) / 3);
    const Pair end = solve(defect, from, 2 * h / 3);
    before = z;
    z = end;
    states.push_back({z[0], z[1]});
  }
  return states;
}

inline std::vector<State> steps(measure::Bdf2, const Force& force, const State& start, Real h,
                                int count) {
  const auto once = [](const auto& defect, const Pair& from, Real part) {
    return newton_step(defect, from, part);
  };
  return bdf2_steps(force, start, h, count, once);
}

inline std::vector<State> steps(measure::Bdf2Newton, const Force& force, const State& start, Real h,
                                int count) {
  const auto to_the_end = [](const auto& defect, const Pair& from, Real part) {
    Pair end = newton_step(defect, from, part);
    for (int n = 0; n < 20; ++n) end -= solved(defect, end);
    return end;
  };
  return bdf2_steps(force, start, h, count, to_the_end);
}

}  // namespace textbook
