// SPDX-License-Identifier: MIT-0
// A damped spring under four methods of chapter 6, as a dot on the plane where their limits are
// drawn.
#include "live/dot_on_the_plane.h"
#include "measure/methods/damping.h"
#include "measure/methods/euler.h"

namespace live {
namespace {

constexpr std::tuple methods{
    Method{"euler", measure::euler}, Method{"symplectic_euler", measure::symplectic_euler},
    Method{"linear_damping_implicit_last", measure::linear_damping_implicit_last},
    Method{"linear_damping_implicit_first", measure::linear_damping_implicit_first}};

}  // namespace

std::unique_ptr<Figure> make_damped() {
  return make_dot_on_the_plane(methods, 2);
}

}  // namespace live
