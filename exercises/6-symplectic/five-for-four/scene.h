// SPDX-License-Identifier: MIT-0
/// @file
/// Compositions of velocity Verlet: the one that is asked for, and what is handed in for it.
/// See M. Suzuki, Fractal decomposition of exponential operators, Physics Letters A 146 (1990).
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "judge/method.h"
#include "judge/random.h"

namespace suzuki {

using judge::Method;
using judge::Step;

/// @param parts  of a step
inline Method composed(const std::string& name, const std::vector<double>& parts) {
  return {name, [parts]() -> Step {
            return [parts, a = Vec{}, begun = false](Vec& x, Vec& v, double t, double h,
                                                     const Acceleration& acceleration) mutable {
              if (!begun) a = acceleration(x, v, t);
              begun = true;
              for (const double part : parts) {
                v += part * h / 2 * a;
                x += part * h * v;
                a = acceleration(x, v, t + part * h);
                t += part * h;
                v += part * h / 2 * a;
              }
            };
          }};
}

inline std::vector<double> five(double outer) {
  return {outer, outer, 1 - 4 * outer, outer, outer};
}

inline const Method asked =
    composed("the composition of five parts", five(1 / (4 - std::cbrt(4.0))));

/// A force that bends with position and time, and brakes nothing.
inline harness::Force draw_force(judge::Random& random) {
  harness::Force force = random.wild();
  force.a[6] = 0;
  return force;
}

}  // namespace suzuki
