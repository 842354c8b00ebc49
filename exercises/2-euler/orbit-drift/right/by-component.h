// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline double forward(double value, double rate, double h) {
  return value + rate * h;
}

inline Vec forward(const Vec& value, const Vec& rate, double h) {
  return {forward(value.x, rate.x, h), forward(value.y, rate.y, h), forward(value.z, rate.z, h)};
}

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const auto a = acceleration(x, v, t);
  const Vec next = forward(x, v, h);
  v = forward(v, a, h);
  x = next;
}
