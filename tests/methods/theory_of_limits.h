// SPDX-License-Identifier: MIT-0
// Where paper says that a method stops being stable: where a root of the characteristic polynomial
// leaves the unit circle.
#pragma once
#include <algorithm>
#include <cmath>

#include "measure/eigenvalues.h"
#include "theory.h"

namespace theory {

// The size of the largest root.
inline double radius(const Polynomial& p) {
  Eigen::Matrix4d companion;
  companion << -p[0], -p[1], -p[2], -p[3], 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0;
  return measure::largest_eigenvalue(companion);
}

// Of the velocity alone: drag leaves the position where it is, which is a root of one.
inline double radius_of_velocity(const Polynomial& p) {
  return radius({1 + p[0], 1 + p[0] + p[1], 1 + p[0] + p[1] + p[2], 0});
}

// The first place, looking outwards in small strides, where `growth` exceeds 1, or nowhere. Where
// it should be 1 it is so up to rounding. What grows after the first stride grows at once, if as
// slowly as the fourth power of the step.
template <class Growth>
double first_unstable(Growth growth) {
  const auto unstable = [&growth](double at) { return growth(at) > 1 + 1e-12; };
  constexpr double stride = 1.0 / 64;
  if (unstable(stride)) return 0;
  double inside = 0, outside = stride;
  while (!unstable(outside)) {
    if (outside > 12) return measure::always;
    inside = outside, outside += stride;
  }
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = (inside + outside) / 2;
    (unstable(middle) ? outside : inside) = middle;
  }
  return inside;
}

template <class Method>
double drag_limit(Method method) {
  return first_unstable(
      [&](double ch) { return radius_of_velocity(characteristic(method, drag(ch))); });
}

// On a damped spring, in h omega: the polynomial's, or its closed form where there is one.
template <class Method>
double spring_limit_of_polynomial(Method method, double zeta) {
  return first_unstable(
      [&](double angle) { return radius(characteristic(method, spring(angle, zeta))); });
}
template <class Method>
double spring_limit(Method method, double zeta) {
  return spring_limit_of_polynomial(method, zeta);
}
inline double spring_limit(measure::Euler, double zeta) {
  return zeta <= 1 ? 2 * zeta : 2 * (zeta - std::sqrt(zeta * zeta - 1));
}
inline double spring_limit(measure::ConstantAcceleration, double zeta) {
  // The determinant is one at 4 zeta; there is a root of -1 at c h = 2.
  return std::min(4 * zeta, 1 / zeta);
}
// These two have a root of -1 where s + 2 d = 4, and where s + 4 d = 4.
inline double spring_limit(
    OneOf<measure::SymplecticEuler, measure::SymplecticEulerPositionFirst, measure::StormerVerlet,
          measure::StormerVerletDistance, measure::StormerVerletUneven, measure::Leapfrog,
          measure::LeapfrogDrift> auto,
    double zeta) {
  return 2 * (std::sqrt(1 + zeta * zeta) - zeta);
}
inline double spring_limit(OneOf<measure::StormerVerletCarried, measure::VelocityVerlet> auto,
                           double zeta) {
  return 2 * (std::sqrt(1 + 4 * zeta * zeta) - 2 * zeta);
}

}  // namespace theory
