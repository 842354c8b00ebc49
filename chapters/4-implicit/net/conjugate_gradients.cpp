// SPDX-License-Identifier: MIT-0
#include "conjugate_gradients.h"

#include <Eigen/IterativeLinearSolvers>
#include <string>
#include <vector>

#include "matrix_costs.h"

IterativeSolve by_conjugate_gradients(const scenes::Cloth<>& scene, double residual) {
  MassSpringState s = with_random_velocities(scene, gentle);
  const double begun = scene.energy(s.x, s.v);
  const int unknowns = int(s.x.size());
  Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(residual);
  IterativeSolve found;
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
    const double each = double(work_of_iteration(matrix)) / unknowns;
    found.multiplications += double(solver.iterations()) * each / 60;
    if (n == 0) found.first = scene.energy(s.x, s.v) / begun;
  }
  found.last = scene.energy(s.x, s.v) / begun;
  return found;
}

void record_substeps_and_iterations(measure::Record& record) {
  const auto compare = [&](const std::string& name, const auto& scene) {
    record.number(name + "-barely", most_energy(scene, substeps_for(scene)), 2);
    record.number(name + "-fifth", substeps_within_a_fifth(scene), measure::whole);
  };
  compare("chain", steel_chain);
  compare("rope", steel_rope);
  compare("cloth", steel_cloth);
  record.number("chain-stored", most_energy(steel_chain, substeps_for(steel_chain), 0), 3);
  record.number("fastest-out", 1e6 * gentle / highest_frequency(steel_chain), 2, "µm");
  record.number("chain-out", 1e3 * farthest(steel_chain), 2, "mm");
  record.number("rope-fewest", substeps_for(steel_rope), measure::whole);
  record.number("cloth-substeps", substeps_for(steel_cloth), measure::whole);
  const auto loose = by_conjugate_gradients(cloth_of(18), 1e-2);
  const auto tight = by_conjugate_gradients(cloth_of(18), 1e-3);
  record.number("cg-loose", loose.iterations, 2);
  record.number("cg-loose-first", loose.first, 2);
  record.number("cg-tight", tight.iterations, 3);
  record.number("cg-tight-work", tight.multiplications, 2);
}
