// SPDX-License-Identifier: MIT-0
// The implicit methods alike, for tests of what they do with the answers of a linear system.
#pragma once
#include "integrate/backward_euler.h"
#include "integrate/bdf2.h"
#include "integrate/trapezoid.h"
#include "measure/length.h"

namespace systems {

// Each method as one that either moves on, or says no. Those with one solve need no tolerance.
struct Once {
  static int step(auto& x, auto& v, double h, const auto& a, auto& solve, double) {
    return integrate::backward_euler(x, v, 0.0, h, a, solve) ? 1 : 0;
  }
};
struct Newton {
  static int step(auto& x, auto& v, double h, const auto& a, auto& solve, double tolerance) {
    const auto size = [](const auto& y) { return measure::length(y); };
    return integrate::backward_euler_newton(x, v, 0.0, h, a, solve, size, tolerance);
  }
};
struct TrapezoidOnce {
  static int step(auto& x, auto& v, double h, const auto& a, auto& solve, double) {
    return integrate::trapezoid(x, v, 0.0, h, a, solve) ? 1 : 0;
  }
};
struct TrapezoidNewton {
  static int step(auto& x, auto& v, double h, const auto& a, auto& solve, double tolerance) {
    const auto size = [](const auto& y) { return measure::length(y); };
    return integrate::trapezoid_newton(x, v, 0.0, h, a, solve, size, tolerance);
  }
};
// From its start each time, so that it needs no memory.
struct Bdf2Once {
  static int step(auto& x, auto& v, double h, const auto& a, auto& solve, double) {
    auto previous = integrate::bdf2_start(x, v, 0.0, h, a);
    return integrate::bdf2(x, v, previous, 0.0, h, h, a, solve) ? 1 : 0;
  }
};
struct Bdf2Newton {
  static int step(auto& x, auto& v, double h, const auto& a, auto& solve, double tolerance) {
    const auto size = [](const auto& y) { return measure::length(y); };
    auto previous = integrate::bdf2_start(x, v, 0.0, h, a);
    return integrate::bdf2_newton(x, v, previous, 0.0, h, h, a, solve, size, tolerance);
  }
};

// x'' = -x^3
inline constexpr auto cubic = [](double x, double, double) { return -x * x * x; };
inline constexpr auto solve_cubic = [](double x, double, double, double p, double, double& change) {
  change = change / (1 - p * 3 * x * x);
  return true;
};

// A tolerance that no change is within.
inline constexpr double unreachable = -1;

}  // namespace systems
