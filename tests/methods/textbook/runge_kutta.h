// SPDX-License-Identifier: MIT-0
// Runge-Kutta methods as their tables: one loop, explicit and implicit ones alike.
#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "measure/methods.h"
#include "problem.h"

namespace textbook {

using Row = std::vector<Real>;

// Row i of `a` makes stage i of the slopes; `b` makes the end of the step of them.
struct Table {
  std::vector<Row> a;
  Row b;
};

using Pair = Eigen::Matrix<Real, 2, 1>;  // position and velocity

inline Pair slope(const Force& force, const Pair& z, Real t) {
  return {z[1], force(z[0], z[1], t)};
}

inline Pair sum(const Row& weights, const std::vector<Pair>& slopes) {
  Pair total = Pair::Zero();
  for (std::size_t i = 0; i < weights.size(); ++i) total += weights[i] * slopes[i];
  return total;
}

// Each stage from the ones that its row names. Where a row names itself, the stages are put into
// their own formula until they stay the same.
inline std::vector<Pair> stages(const Table& table, const Force& force, const Pair& z, Real t,
                                Real h) {
  std::vector<Pair> slopes(table.a.size(), Pair::Zero());
  bool implicit = false;
  for (std::size_t i = 0; i < slopes.size(); ++i) implicit |= table.a[i].size() > i;
  for (int sweep = 0; sweep < (implicit ? 200 : 1); ++sweep) {
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      Real time = 0;
      for (const Real weight : table.a[i]) time += weight;
      slopes[i] = slope(force, z + h * sum(table.a[i], slopes), t + h * time);
    }
  }
  return slopes;
}

inline Table table(measure::Euler) {
  return {{{}}, {1}};
}

inline Table table(measure::Midpoint) {
  return {{{}, {0.5L}}, {0, 1}};
}

inline Table table(measure::Heun) {
  return {{{}, {1}}, {0.5L, 0.5L}};
}

inline Table table(measure::Rk4) {
  return {{{}, {0.5L}, {0, 0.5L}, {0, 0, 1}}, {1 / 6.0L, 1 / 3.0L, 1 / 3.0L, 1 / 6.0L}};
}

inline Table table(measure::Dopri5) {
  const Row end{35 / 384.0L, 0, 500 / 1113.0L, 125 / 192.0L, -2187 / 6784.0L, 11 / 84.0L};
  return {{{},
           {1 / 5.0L},
           {3 / 40.0L, 9 / 40.0L},
           {44 / 45.0L, -56 / 15.0L, 32 / 9.0L},
           {19372 / 6561.0L, -25360 / 2187.0L, 64448 / 6561.0L, -212 / 729.0L},
           {9017 / 3168.0L, -355 / 33.0L, 46732 / 5247.0L, 49 / 176.0L, -5103 / 18656.0L},
           end},
          end};
}

// The end of the step of order 4 that comes with Dormand and Prince's method.
inline const Row dopri4{
    5179 / 57600.0L, 0,        7571 / 16695.0L, 393 / 640.0L, -92097 / 339200.0L,
    187 / 2100.0L,   1 / 40.0L};

// Predicted Euler is explicit: stage after stage at the end of the step, each from the one before.
inline Table predicted_euler(int corrections) {
  Table table{{{}}, {}};
  for (int n = 1; n <= corrections; ++n) {
    Row row(std::size_t(n), 0);
    row.back() = 1;
    table.a.push_back(row);
  }
  table.b.assign(std::size_t(corrections) + 1, 0);
  table.b.back() = 1;
  return table;
}

inline Table table(measure::PredictedEuler) {
  return predicted_euler(1);
}

inline Table table(measure::BackwardEulerNewton) {
  return {{{1}}, {1}};
}

inline Table table(measure::TrapezoidNewton) {
  return {{{}, {0.5L, 0.5L}}, {0.5L, 0.5L}};
}

// The states after each of a few steps from time zero on.
template <class Method>
  requires requires(Method method) { table(method); }
std::vector<State> steps(Method method, const Force& force, const State& start, Real h, int count) {
  std::vector<State> states;
  Pair z{start.x, start.v};
  for (int n = 0; n < count; ++n) {
    const Table t = table(method);
    z += h * sum(t.b, stages(t, force, z, Real(n) * h, h));
    states.push_back({z[0], z[1]});
  }
  return states;
}

}  // namespace textbook
