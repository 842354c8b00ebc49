// SPDX-License-Identifier: MIT-0
// A spring under three methods of chapter 3, as a dot on the plane where their limits are drawn.
#include "live/dot_on_the_plane.h"
#include "measure/methods/euler.h"
#include "measure/methods/runge_kutta.h"

namespace live {

std::unique_ptr<Figure> make_rk4_limits() {
  constexpr std::tuple methods{Method{"euler", measure::euler},
                               Method{"midpoint", measure::midpoint}, Method{"rk4", measure::rk4}};
  return make_dot_on_the_plane(methods, 3.1);
}

}  // namespace live
