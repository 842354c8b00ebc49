// SPDX-License-Identifier: MIT-0
// The GNU Scientific Library, with all planets as one system. One call of its rk4 makes a whole
// step and two halves, 11 evaluations, and returns what the two halves gave: a call with 2h is two
// steps of h.
#pragma once
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <memory>
#include <stdexcept>
#include <vector>

#include "orbit/state.h"

namespace orbit {

inline std::vector<State> with_gsl(const std::vector<State>& from, long steps, double h) {
  const auto slope = [](double, const double y[], double f[], void* count) {
    const std::size_t numbers = 4 * *static_cast<const std::size_t*>(count);
    for (std::size_t i = 0; i < numbers; i += 4) {
      const double p = pull(y[i] * y[i] + y[i + 1] * y[i + 1]);
      f[i] = y[i + 2];
      f[i + 1] = y[i + 3];
      f[i + 2] = p * y[i];
      f[i + 3] = p * y[i + 1];
    }
    return int(GSL_SUCCESS);
  };
  std::size_t count = from.size();
  const gsl_odeiv2_system system{slope, nullptr, 4 * count, &count};
  const std::unique_ptr<gsl_odeiv2_step, void (*)(gsl_odeiv2_step*)> step(
      gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk4, 4 * count), gsl_odeiv2_step_free);
  std::vector<State> all = from;
  std::vector<double> error(4 * count);
  static_assert(sizeof(State) == 4 * sizeof(double));
  for (long n = 0; n < steps; n += 2) {
    const int status = gsl_odeiv2_step_apply(step.get(), double(n) * h, 2 * h, &all[0].x,
                                             error.data(), nullptr, nullptr, &system);
    if (status != GSL_SUCCESS) throw std::runtime_error(gsl_strerror(status));
  }
  return all;
}

}  // namespace orbit
