// SPDX-License-Identifier: MIT-0
// One step of the midpoint method, which looks twice.
#include "live/one_step.h"
#include "measure/methods/runge_kutta.h"

namespace live {

std::unique_ptr<Figure> make_midpoint_step() {
  return std::make_unique<OneStep<measure::Midpoint>>(measure::midpoint);
}

}  // namespace live
