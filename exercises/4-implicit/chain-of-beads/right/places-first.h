// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

using Column = std::vector<double>;

// Solves for the places, (1 + h^2 K) x_new = x + h v, and then takes the forces there.
inline void step(Column& x, Column& v, double h, const Column& k) {
  const std::size_t count = x.size();
  const auto spring = [&](std::size_t i) { return i < count ? k[i] : 0; };
  Column share(count), there(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double left = h * h * spring(i), right = h * h * spring(i + 1);
    const double middle = 1 + left + right - (i > 0 ? left * share[i - 1] : 0);
    share[i] = right / middle;
    there[i] = (x[i] + h * v[i] + (i > 0 ? left * there[i - 1] : 0)) / middle;
  }
  for (std::size_t i = count; i-- > 1;) there[i - 1] += share[i - 1] * there[i];
  for (std::size_t i = 0; i < count; ++i) {
    const double before = i > 0 ? there[i - 1] : 0, after = i + 1 < count ? there[i + 1] : 0;
    v[i] += h * (spring(i + 1) * (after - there[i]) - k[i] * (there[i] - before));
    x[i] += h * v[i];
  }
}
