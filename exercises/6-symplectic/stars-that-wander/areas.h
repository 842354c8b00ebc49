// SPDX-License-Identifier: MIT-0
/// @file
/// What a step does to the areas between neighbouring starts.
#pragma once
#include "stars.h"

namespace stars {

/// A small way from one start to another, for each star; or what a step made of it.
using Aside = std::vector<State>;

inline Aside draw_aside(judge::Random& random, std::size_t count) {
  Aside aside(count);
  for (State& star : aside) star = {random.vector(-1, 1), random.vector(-1, 1)};
  return aside;
}

/// The area that two of them span, each star's times its mass.
inline double area(const std::vector<double>& mu, const Aside& a, const Aside& b) {
  double sum = 0;
  for (std::size_t i = 0; i < mu.size(); ++i) {
    sum += mu[i] * (dot(a[i].x, b[i].v) - dot(a[i].v, b[i].x));
  }
  return sum;
}

/// What a step makes of `aside`: the difference of two steps from a little to either side.
/// @param step  callable `(Stars) -> Stars`
template <class Step>
Aside carried(const Step& step, const Stars& start, const Aside& aside, double share) {
  Stars there = start, opposite = start;
  for (std::size_t i = 0; i < aside.size(); ++i) {
    there.at[i].x += share * aside[i].x;
    there.at[i].v += share * aside[i].v;
    opposite.at[i].x -= share * aside[i].x;
    opposite.at[i].v -= share * aside[i].v;
  }
  const Stars a = step(there), b = step(opposite);
  Aside result;
  for (std::size_t i = 0; i < aside.size(); ++i) {
    result.push_back(
        {(a.at[i].x - b.at[i].x) / (2 * share), (a.at[i].v - b.at[i].v) / (2 * share)});
  }
  return result;
}

}  // namespace stars
