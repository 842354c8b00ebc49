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

/// What the clock does from one part to the next.
enum Clock { runs, stands, runs_by_h };

/// @param parts  of a step
inline Method composed(const std::string& name, const std::vector<double>& parts,
                       Clock clock = runs) {
  return {name, [parts, clock]() -> Step {
            return
                [parts, clock, a = Vec{}, begun = false](Vec& x, Vec& v, double t, double h,
                                                         const Acceleration& acceleration) mutable {
                  if (!begun) a = acceleration(x, v, t);
                  begun = true;
                  for (const double part : parts) {
                    v += part * h / 2 * a;
                    x += part * h * v;
                    a = acceleration(x, v, t + part * h);
                    if (clock != stands) t += (clock == runs ? part : 1) * h;
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

/// A function, since the judge's own methods may be made after what stands in this header.
inline std::vector<Method> others() {
  const double outer = 1 / (4 - std::cbrt(4.0)), middle = 1 - 4 * outer;
  return {
      judge::velocity_verlet,
      judge::yoshida4,
      composed("five parts of equal length", five(0.2)),
      composed("five parts with alpha = 1/3, which is what pow(4, 1 / 3) gives in whole numbers",
               five(1.0 / 3)),
      composed("five parts with alpha = 1 / (4 - cbrt(2))", five(1 / (4 - std::cbrt(2.0)))),
      composed("five parts with alpha = 1 / (2 - cbrt(2)), Yoshida's",
               five(1 / (2 - std::cbrt(2.0)))),
      composed("five parts with alpha = 1 / (4 - sqrt(4))", five(0.5)),
      composed("five parts with beta = 1 - 2 alpha: they add up to more than a step",
               {outer, outer, 1 - 2 * outer, outer, outer}),
      composed("the five parts with the one back first: they don't read the same from both ends",
               {middle, outer, outer, outer, outer}),
      composed("the five parts with the one back last: they don't read the same from both ends",
               {outer, outer, outer, outer, middle}),
      composed("the five parts with the one back turned forward: beta is less than nothing",
               {outer, outer, -middle, outer, outer}),
      composed("the five parts, all of them told the time at which the step starts", five(outer),
               stands),
      composed("the five parts, with a clock that goes on by all of h after each of them",
               five(outer), runs_by_h),
  };
}

/// Whether a question was asked a second time, of which the step already has the answer.
inline bool asks_again(const judge::Path& path) {
  const auto alike = [](const judge::Evaluation& one, const judge::Evaluation& next) {
    return length(next.x - one.x) + std::abs(next.t - one.t) <= 1e-10;
  };
  const auto& questions = path.evaluations;
  return std::adjacent_find(questions.begin(), questions.end(), alike) != questions.end();
}

/// Bends with place and time, and brakes nothing.
inline harness::Force draw_force(judge::Random& random) {
  harness::Force force = random.wild();
  force.a[6] = 0;
  return force;
}

}  // namespace suzuki
