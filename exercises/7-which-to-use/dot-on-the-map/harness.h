// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds most{"most", 0.001, 1000};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<double(const std::function<void(double& x, double& v)>& step)> wanted_growth =
    growth;
const harness::Wanted<double(const std::function<void(double& x, double& v, double h)>& step,
                             double most)>
    wanted_longest = longest_step;
const harness::Within within_longest{wanted_longest, {harness::any, harness_bounds::most}};

// A matrix, each entry a polynomial of degree 4 in h over one of degree 2; and a rest.
struct Hidden {
  std::vector<double> above, below;  // above: xx xv vx vv
  double x_rest, v_rest;

  explicit Hidden(harness::Call& call)
      : above(call.numbers(20)),
        below(call.numbers(3)),
        x_rest(call.number()),
        v_rest(call.number()) {}

  double entry(std::size_t which, double h) const {
    double sum = 0;
    for (std::size_t power = 5; power-- > 0;) sum = sum * h + above[5 * which + power];
    return sum / (below[0] + h * (below[1] + h * below[2]));
  }

  void step(double& x, double& v, double h) const {
    const double dx = x - x_rest, dv = v - v_rest;
    x = x_rest + entry(0, h) * dx + entry(1, h) * dv;
    v = v_rest + entry(2, h) * dx + entry(3, h) * dv;
  }
};

void answer(harness::Call& call) {
  const Hidden hidden(call);
  const double h = call.number();
  if (call.function() == 0) {
    call.answer(wanted_growth([&](double& x, double& v) { hidden.step(x, v, h); }));
  } else {
    call.answer(wanted_longest([&](double& x, double& v, double h) { hidden.step(x, v, h); }, h));
  }
}

#endif
