// SPDX-License-Identifier: MIT-0
// What paper says of the ways to damp within a step of symplectic Euler: each makes v into
// keep v + push h a, and then x into x + h v.
#pragma once
#include <algorithm>
#include <cmath>

#include "theory.h"

namespace theory {

struct Damped {
  double keep, push;
};

inline Damped damped(measure::LinearDampingExplicitLast, double ch) {
  const double keep = std::max(0.0, 1 - ch);
  return {keep, keep};
}
inline Damped damped(measure::LinearDampingExplicitFirst, double ch) {
  return {std::max(0.0, 1 - ch), 1};
}
inline Damped damped(measure::LinearDampingImplicitLast, double ch) {
  return {1 / (1 + ch), 1 / (1 + ch)};
}
inline Damped damped(measure::LinearDampingImplicitFirst, double ch) {
  return {1 / (1 + ch), 1};
}
inline Damped damped(measure::LinearDampingExponentialLast, double ch) {
  return {std::exp(-ch), std::exp(-ch)};
}
inline Damped damped(measure::LinearDampingExponentialFirst, double ch) {
  return {std::exp(-ch), 1};
}
inline Damped damped(measure::LinearDampingExact, double ch) {
  return {std::exp(-ch), ch == 0 ? 1 : -std::expm1(-ch) / ch};
}

// The matrix on x and h v is [1 - push s, keep; -push s, keep].
template <class Method>
  requires requires { damped(Method(), 0.0); }
Polynomial characteristic(Method method, Force f) {
  const auto [keep, push] = damped(method, f.d);
  return {push * f.s - 1 - keep, keep, 0};
}

}  // namespace theory
