// SPDX-License-Identifier: MIT-0
// The GNU Scientific Library. One call of its rk4 makes a whole step and two halves, 11
// evaluations, and returns what the two halves gave: a call with 2h is two steps of h.
#pragma once
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <memory>
#include <stdexcept>

#include "orbit/state.h"

namespace orbit {

class WithGsl {
 public:
  State operator()(State s, long steps, double h) const {
    gsl_odeiv2_step_reset(step_.get());
    const gsl_odeiv2_system system{slope, nullptr, 4, nullptr};
    double y[4] = {s.x, s.y, s.vx, s.vy};
    double error[4];
    for (long n = 0; n < steps; n += 2) {
      const int status = gsl_odeiv2_step_apply(step_.get(), double(n) * h, 2 * h, y, error, nullptr,
                                               nullptr, &system);
      if (status != GSL_SUCCESS) throw std::runtime_error(gsl_strerror(status));
    }
    return {y[0], y[1], y[2], y[3]};
  }

 private:
  static int slope(double, const double y[], double f[], void*) {
    const double p = pull(y[0] * y[0] + y[1] * y[1]);
    f[0] = y[2];
    f[1] = y[3];
    f[2] = p * y[0];
    f[3] = p * y[1];
    return GSL_SUCCESS;
  }

  std::shared_ptr<gsl_odeiv2_step> step_{gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk4, 4),
                                         gsl_odeiv2_step_free};
};

}  // namespace orbit
