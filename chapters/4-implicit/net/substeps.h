// SPDX-License-Identifier: MIT-0
/// @file
/// Substeps and solved steps in chapter 4: how many it takes, and multiplications of each.
#pragma once
#include <cmath>
#include <cstdlib>

#include "integrate/symplectic_euler.h"
#include "nets.h"
#include "op_counted.h"

/// Multiplications and the like in what `run` does.
template <class Run>
double count_operations(Run run) {
  OpCounted::operations = 0;
  run();
  return double(OpCounted::operations);
}

/// Multiplications of one step of symplectic Euler.
template <class Scene>
double work_of_substep(const Scene& scene) {
  auto s = scene.start();
  return count_operations(
      [&] { integrate::symplectic_euler(s.x, s.v, 0.0, OpCounted(frame), scene); });
}

/// Multiplications of one step of backward Euler with a band.
template <class Scene>
double work_of_step(const Scene& scene) {
  auto s = scene.start();
  auto system = system_of(scene);
  return count_operations([&] {
    if (!integrate::backward_euler(s.x, s.v, 0.0, OpCounted(frame), scene, system)) std::abort();
  });
}

/// The frequency of the fastest mode, by the power method, from below [rad/s].
template <class Scene>
double highest_frequency(const Scene& scene) {
  const auto s = scene.start();
  Eigen::VectorXd mode = with_random_velocities(scene, 1).v;
  double squared = 0;
  for (int n = 0; n < 200; ++n) {
    Eigen::VectorXd pulled = Eigen::VectorXd::Zero(mode.size());
    scene.jacobian(s.x, s.v, 0.0,
                   [&](int i, int j, double dadx, double) { pulled[i] -= dadx * mode[j]; });
    squared = pulled.norm();
    mode = pulled / squared;
  }
  return std::sqrt(squared);
}

/// Fewest steps of symplectic Euler in a frame that hold a scene.
template <class Scene>
int substeps_for(const Scene& scene) {
  return int(std::ceil(frame * highest_frequency(scene) / 2));
}
