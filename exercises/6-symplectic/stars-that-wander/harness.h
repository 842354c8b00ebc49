// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds stars{"stars", 1, 64, 2}, h{"h", 0.001, 0.2};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<void(std::vector<Vec>& x, std::vector<Vec>& v, const std::vector<double>& mu,
                           double h)>
    wanted = step;
const harness::Within within_wanted{
    wanted, {harness_bounds::stars, harness::any, harness::any, harness_bounds::h}};

// Steps, size of a step, how many stars, and each star's x, v and mu; answers with all after each.
void answer(harness::Call& call) {
  const int steps = call.whole_number();
  const double h = call.number();
  const auto count = static_cast<std::size_t>(call.whole_number());
  std::vector<Vec> x(count), v(count);
  std::vector<double> mu(count);
  for (std::size_t i = 0; i < count; ++i) {
    x[i] = call.vector();
    v[i] = call.vector();
    mu[i] = call.number();
  }
  for (int n = 0; n < steps; ++n) {
    wanted(x, v, mu, h);
    for (std::size_t i = 0; i < count; ++i) {
      call.answer(x.at(i));
      call.answer(v.at(i));
    }
  }
}

#endif
