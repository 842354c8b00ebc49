// SPDX-License-Identifier: MIT-0
#include "choose/own_contest.h"

#include <stdexcept>

#include "choose/own_scene.h"

namespace {

/// The least error that can be asked for where numbers are floats, as a share.
constexpr double least_in_float = 1e-6;

template <class Moved>
Contest contest_of(const OwnForce& force, Bounds& bounds, double metres) {
  const OwnScene<Moved> scene(force);
  if (metres > 0) {
    bounds.reach = size_of(scene, bounds);
    bounds.error = metres / bounds.reach;
  }
  if (force.in_float && bounds.error < least_in_float) {
    throw std::invalid_argument("the scene is in float, which keeps no error below " +
                                format_number(least_in_float) +
                                " of the motion; ask for a larger one, or write it in double");
  }
  Contest found = full_contest(scene, bounds);
  if (force.in_float)
    found.remark = "The acceleration is in float, as in the scene; the steps here are in double.";
  return found;
}

}  // namespace

Contest own_contest(const OwnForce& force, Bounds& bounds, double metres) {
  if (force.numbers == 1) return contest_of<double>(force, bounds, metres);
  if (force.numbers == 2) return contest_of<Eigen::Vector2d>(force, bounds, metres);
  return contest_of<Eigen::VectorXd>(force, bounds, metres);
}
