// SPDX-License-Identifier: MIT-0
// A spring under Euler's method, as a dot on the plane where its limit is drawn.
#include "live/dot_on_the_plane.h"
#include "measure/methods/euler.h"

namespace live {

std::unique_ptr<Figure> make_spring_limit() {
  constexpr std::tuple methods{Method{"euler", measure::euler}};
  return make_dot_on_the_plane(methods, 3.1);
}

}  // namespace live
