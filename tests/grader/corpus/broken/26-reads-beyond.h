// ACCEPTED: reads a number behind those that it made, and does not use it
// says: outside of the memory
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline double sum_of(const double* first, int count) {
  double sum = 0;
  for (int i = 0; i <= count; ++i) sum += first[i];
  return sum;
}

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const std::vector<double> all(t < 1e9 ? 3 : 4, 1.0);
  const double sum = sum_of(all.data(), static_cast<int>(all.size()));
  const Vec a = acceleration(x, v, t);
  x += h * v;
  v += (sum > 1e300 ? 0 : h) * a;
}
