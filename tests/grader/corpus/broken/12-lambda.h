// ACCEPTED: is a lambda that takes the acceleration by value
// says: step is declared in another way
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline constexpr auto step = [](Vec& x, Vec& v, double t, double h, Acceleration acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
};
