// SPDX-License-Identifier: MIT-0
/// @file
/// The cost of a step of a stiff scene in chapter 4: entries of its matrix, and multiplications.
#pragma once
#include <Eigen/SparseCore>
#include <cmath>
#include <string>
#include <vector>

#include "measure/record.h"
#include "nets.h"
#include "substeps.h"

using Sparse = Eigen::SparseMatrix<double>;

/// The matrix of a step from the scene's start.
template <class Scene>
Sparse step_matrix_of(const Scene& scene) {
  const auto s = scene.start();
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < int(s.x.size()); ++i) entries.emplace_back(i, i, 1.0);
  scene.jacobian(s.x, s.v, 0.0, [&](int i, int j, double dadx, double dadv) {
    entries.emplace_back(i, j, -frame * frame * dadx - frame * dadv);
  });
  Sparse matrix(s.x.size(), s.x.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// The factor of a matrix below its diagonal, by elimination in an order that fills in little.
Sparse factor_of(const Sparse& matrix);

/// Multiplications and divisions that make this factor, and that solve with it.
inline double work_of_solving(const Sparse& factor) {
  double work = 0;
  for (int column = 0; column < factor.cols(); ++column) {
    const double below = double(factor.col(column).nonZeros());
    work += below * (below + 3) / 2;  // of the factor
    work += 2 * below + 1;            // forth and back, and the diagonal
  }
  return work;
}

/// Multiplications of an iteration of conjugate gradients: the matrix once; two products of
/// vectors, three sums of them and the diagonal.
inline long work_of_iteration(const Sparse& matrix) {
  return long(matrix.nonZeros() + 6 * matrix.cols());
}

/// Multiplications that make the matrix of a step.
template <class Scene>
double work_of_filling(const Scene& scene) {
  const auto s = scene.start();
  return count_operations([&] {
    const OpCounted p = -frame * frame, q = -frame;
    OpCounted sum = 0;
    scene.jacobian(s.x, s.v, 0.0,
                   [&](int, int, OpCounted dadx, OpCounted dadv) { sum += p * dadx + q * dadv; });
  });
}

/// Multiplications of one step of backward Euler on cloth, by the entries of its factor.
inline double work_of_step(const scenes::Cloth<OpCounted>& scene) {
  const auto s = scene.start();
  const Sparse factor = factor_of(step_matrix_of(cloth_of(scene.side)));
  return work_of_filling(scene) + work_of_substep(scene) + double(s.x.size()) +
         work_of_solving(factor);
}

/// Records which entries of the matrices of chain, rope and cloth are not zero.
void matrices(measure::Record& record);

/// Records the cost of a frame, solved and in substeps.
void costs(measure::Record& record);

/// Records it for a rope on a nail, over the stiffness of its springs.
void costs_on_a_nail(measure::Record& record);
