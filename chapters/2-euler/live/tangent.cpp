// SPDX-License-Identifier: MIT-0
// One step of Euler's method, along the tangent.
#include "live/one_step.h"
#include "measure/methods/euler.h"

namespace live {

std::unique_ptr<Figure> make_tangent() {
  return std::make_unique<OneStep<measure::Euler>>(measure::euler);
}

}  // namespace live
