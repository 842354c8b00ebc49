// PARTIAL|WRONG_ANSWER: computes in single precision
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  const float step = static_cast<float>(h);
  const auto single = [](double value) { return static_cast<float>(value); };
  const Vec old = v;
  v = {single(v.x) + step * single(a.x), single(v.y) + step * single(a.y),
       single(v.z) + step * single(a.z)};
  x = {single(x.x) + step * single(old.x), single(x.y) + step * single(old.y),
       single(x.z) + step * single(old.z)};
}
