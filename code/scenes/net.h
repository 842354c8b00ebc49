// SPDX-License-Identifier: MIT-0
/// @file
/// Masses in space with springs between them: what rope and cloth have in common.
#pragma once
#include <Eigen/Core>

#include "scenes/link.h"

namespace scenes {

// A net is a scene with the members
//   nodes()               how many masses
//   mass_of(i)            of a node [kg]
//   held(i)               whether a node keeps its velocity, whatever pulls at it
//   for_each_link(visit)  calls visit(i, j, link) for each spring
//   g                     acceleration of gravity, against the second axis [m/s^2]
// A node has three unknowns, one after the other; the second of them is its height.

/// Position or velocity of one node of a net.
template <class Vec>
auto node(const Vec& all, int i) {
  return all.template segment<3>(3 * Eigen::Index(i));
}

/// The accelerations of all nodes [m/s^2].
/// @param net  rope or cloth
/// @param x  positions [m]
/// @param v  velocities [m/s]
template <class Net, class Vec>
Vec net_acceleration(const Net& net, const Vec& x, const Vec& v) {
  Vec a = Vec::Zero(x.size());
  net.for_each_link([&](int i, int j, const auto& link) {
    const auto pull = link.pull(node(x, j) - node(x, i), node(v, j) - node(v, i));
    a.template segment<3>(3 * i) += pull;
    a.template segment<3>(3 * j) -= pull;
  });
  for (int i = 0; i < net.nodes(); ++i) {
    auto here = a.template segment<3>(3 * i);
    here /= net.mass_of(i);
    here.y() -= net.g;
    if (net.held(i)) here.setZero();
  }
  return a;
}

/// Hands the derivatives of the accelerations on; see Link::stiffness for what is left out.
///
/// Held nodes have neither rows nor columns: they do not change their velocity in a step, so that
/// nothing depends on how they would.
/// @param net  rope or cloth
/// @param x  positions [m]
/// @param add  called as `add(i, j, dadx, dadv)`
template <class Net, class Vec, class Add>
void net_jacobian(const Net& net, const Vec& x, Add&& add) {
  net.for_each_link([&](int i, int j, const auto& link) {
    const auto dx = link.stiffness(node(x, j) - node(x, i));
    const auto dv = link.damping(node(x, j) - node(x, i));
    const auto add_block = [&](int to, int from, auto weight) {
      if (net.held(to) || net.held(from)) return;
      const auto w = weight / net.mass_of(to);
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
          add(3 * to + row, 3 * from + column, w * dx(row, column), w * dv(row, column));
        }
      }
    };
    using Real = typename Vec::Scalar;
    add_block(i, i, Real(-1));
    add_block(i, j, Real(1));
    add_block(j, i, Real(1));
    add_block(j, j, Real(-1));
  });
}

/// Energy of motion, springs and height [J].
/// @param net  rope or cloth
/// @param x  positions [m]
/// @param v  velocities [m/s]
template <class Net, class Vec>
typename Vec::Scalar net_energy(const Net& net, const Vec& x, const Vec& v) {
  typename Vec::Scalar sum = 0;
  net.for_each_link(
      [&](int i, int j, const auto& link) { sum += link.energy(node(x, j) - node(x, i)); });
  for (int i = 0; i < net.nodes(); ++i) {
    sum += net.mass_of(i) * (node(v, i).squaredNorm() / 2 + net.g * node(x, i).y());
  }
  return sum;
}

}  // namespace scenes
