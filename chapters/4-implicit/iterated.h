// SPDX-License-Identifier: MIT-0
/// @file
/// The cloth of chapter 4 solved by conjugate gradients, and its energy in few substeps.
#pragma once
#include <Eigen/IterativeLinearSolvers>
#include <algorithm>
#include <string>
#include <vector>

#include "measure/record.h"
#include "struck.h"
#include "substeps.h"
#include "work.h"

/// What a second of backward Euler took and did, each step solved by conjugate gradients.
struct Iterated {
  double iterations = 0;       ///< of a step, on average
  double multiplications = 0;  ///< of a step and unknown, for the iterations alone
  double first = 0;            ///< share of the energy after the first step
  double last = 0;             ///< share of the energy after the last one
};

/// A second after a gentle blow.
/// @param residual  the largest of a step, over the size of the right side
template <class Scene>
Iterated by_conjugate_gradients(const Scene& scene, double residual) {
  Struck s = struck(scene, gentle);
  const double begun = scene.energy(s.x, s.v);
  const int unknowns = int(s.x.size());
  Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(residual);
  Iterated found;
  for (int n = 0; n < 60; ++n) {
    const Eigen::VectorXd ahead = s.x + frame * s.v;
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < unknowns; ++i) entries.emplace_back(i, i, 1.0);
    scene.jacobian(ahead, s.v, 0.0, [&](int i, int j, double dadx, double dadv) {
      entries.emplace_back(i, j, -frame * frame * dadx - frame * dadv);
    });
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::VectorXd right_side = frame * scene(ahead, s.v, 0.0);
    s.v += solver.compute(matrix).solve(right_side);
    s.x += frame * s.v;
    found.iterations += double(solver.iterations()) / 60;
    // The matrix once; two products of vectors, three sums of them and the diagonal.
    const double each = double(matrix.nonZeros()) / unknowns + 6;
    found.multiplications += double(solver.iterations()) * each / 60;
    if (n == 0) found.first = scene.energy(s.x, s.v) / begun;
  }
  found.last = scene.energy(s.x, s.v) / begun;
  return found;
}

/// The most energy that a net has within a second of a gentle blow in substeps of symplectic Euler,
/// over that of the blow.
/// @param ahead  the part of a kick that the velocity is given for the energy: half of one brings
///               it to the time of the position, and 0 takes it as it is stored
template <class Scene>
double most_energy(const Scene& scene, int substeps, double ahead = 0.5) {
  Struck s = struck(scene, gentle);
  const double begun = scene.energy(s.x, s.v), step = frame / substeps;
  double most = 1;
  for (int n = 0; n < 60 * substeps; ++n) {
    integrate::symplectic_euler(s.x, s.v, 0.0, step, scene);
    const Eigen::VectorXd now = s.v + ahead * step * scene(s.x, s.v, 0.0);
    most = std::max(most, scene.energy(s.x, now) / begun);
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

/// What substeps that barely hold do to the energy, what it takes to do better, and what an
/// iterated solve would cost.
inline void fairer(measure::Record& record) {
  const auto compare = [&](const std::string& name, const auto& scene, const auto& tallied) {
    const int enough = substeps_within_a_fifth(scene);
    record.number(name + "-barely", most_energy(scene, substeps_for(scene)), 2);
    record.number(name + "-fifth", enough, measure::whole);
    record.number(name + "-fair", enough * work_of_substep(tallied) / work_of_step(tallied), 2);
  };
  compare("chain", chain, chain_of<Tallied>(chain.count));
  compare("rope", rope, rope_of<Tallied>(rope.count));
  compare("cloth", cloth, cloth_of<Tallied>(cloth.side));
  record.number("chain-stored", most_energy(chain, substeps_for(chain), 0), 3);
  record.number("cloth-substeps", substeps_for(cloth), measure::whole);
  const auto loose = by_conjugate_gradients(cloth_of(18), 1e-2);
  const auto tight = by_conjugate_gradients(cloth_of(18), 1e-3);
  record.number("cg-loose", loose.iterations, 2);
  record.number("cg-loose-first", loose.first, 2);
  record.number("cg-tight", tight.iterations, 3);
  record.number("cg-tight-work", tight.multiplications, 2);
}
