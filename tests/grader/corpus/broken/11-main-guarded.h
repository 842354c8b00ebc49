// ACCEPTED: has a main behind #ifndef GRADING
// SPDX-License-Identifier: MIT-0
#pragma once
#include <iostream>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}

#ifndef GRADING
int main() {
  Vec x = {1, 0, 0}, v = {0, 1, 0};
  step(x, v, 0, 0.1, [](const Vec& y, const Vec&, double) { return -y; });
  std::cout << x.x << '\n';
}
#endif
