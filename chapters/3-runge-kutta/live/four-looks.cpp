// SPDX-License-Identifier: MIT-0
// One step of RK4, which looks four times.
#include "live/one_step.h"
#include "measure/methods/runge_kutta.h"

namespace live {

std::unique_ptr<Figure> make_four_looks() {
  return std::make_unique<OneStep<measure::Rk4>>(measure::rk4);
}

}  // namespace live
