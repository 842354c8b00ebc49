// SPDX-License-Identifier: MIT-0
/// @file
/// The cloth of chapter 4 solved by conjugate gradients, and its energy in few substeps.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "matrix_costs.h"
#include "measure/record.h"
#include "nets.h"
#include "substeps.h"

/// The cost and the energy of a second of backward Euler, each step solved by conjugate gradients.
struct IterativeSolve {
  double iterations = 0;       ///< of a step, on average
  double multiplications = 0;  ///< of a step and unknown, for the iterations alone
  double first = 0;            ///< share of the energy after the first step
  double last = 0;             ///< share of the energy after the last one
};

/// Runs a second after a gentle blow.
/// @param residual  the largest of a step, over the size of the right side
IterativeSolve by_conjugate_gradients(const scenes::Cloth<>& scene, double residual);

/// The most energy that a net has within a second of a gentle blow in substeps of symplectic Euler,
/// over that of the blow.
/// @param ahead  the part of a kick that the velocity is given for the energy: half of one brings
///               it to the time of the position, and 0 takes it as it is stored
template <class Scene>
double most_energy(const Scene& scene, int substeps, double ahead = 0.5) {
  MassSpringState s = with_random_velocities(scene, gentle);
  const double begun = scene.energy(s.x, s.v), step = frame / substeps;
  double most = 1;
  for (int n = 0; n < 60 * substeps; ++n) {
    integrate::symplectic_euler(s.x, s.v, 0.0, step, scene);
    const Eigen::VectorXd now = s.v + ahead * step * scene(s.x, s.v, 0.0);
    most = std::max(most, scene.energy(s.x, now) / begun);
  }
  return most;
}

/// The farthest that any mass of the chain goes from its place within a second of a gentle blow, in
/// substeps
/// so many that it is the true motion [m].
inline double farthest(const scenes::Chain<>& chain) {
  constexpr int substeps = 400;
  MassSpringState s = with_random_velocities(chain, gentle);
  const Eigen::VectorXd at_rest = s.x;
  double most = 0;
  for (int n = 0; n < 60 * substeps; ++n) {
    integrate::symplectic_euler(s.x, s.v, 0.0, frame / substeps, chain);
    most = std::max(most, (s.x - at_rest).cwiseAbs().maxCoeff());
  }
  return most;
}

/// Fewest substeps in which the energy stays within a fifth above that of the blow.
template <class Scene>
int substeps_within_a_fifth(const Scene& scene) {
  int substeps = substeps_for(scene);
  while (most_energy(scene, substeps) > 1.2) ++substeps;
  return substeps;
}

/// Records the energy in substeps that barely hold, the substeps that do better, and the cost of an
/// iterative solve.
void record_substeps_and_iterations(measure::Record& record);
