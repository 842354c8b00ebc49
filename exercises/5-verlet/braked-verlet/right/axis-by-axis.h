// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

template <class Real>
Real solved(Real x, Real before, Real a, Real c, Real h) {
  const Real unknown = 1 / (h * h) + c / (2 * h);
  return (2 * x / (h * h) - before * (1 / (h * h) - c / (2 * h)) + a) / unknown;
}

inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double c, double h) {
  return {solved(x.x, x_previous.x, a.x, c, h), solved(x.y, x_previous.y, a.y, c, h),
          solved(x.z, x_previous.z, a.z, c, h)};
}
