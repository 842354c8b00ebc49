// SPDX-License-Identifier: MIT-0
/// @file
/// What a step of a stiff scene costs in chapter 4: entries of its matrix, and multiplications.
#pragma once
#include <Eigen/SparseCholesky>
#include <cmath>
#include <string>
#include <vector>

#include "hanging.h"
#include "measure/record.h"
#include "struck.h"
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
inline Sparse factor_of(const Sparse& matrix) {
  return Eigen::SimplicialLDLT<Sparse>(matrix).matrixL().nestedExpression();
}

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

/// The same for cloth, whose factor is not made of counted numbers but of counted entries.
inline double work_of_step(const scenes::Cloth<Tallied>& scene) {
  const auto s = scene.start();
  const Sparse factor = factor_of(step_matrix_of(cloth_of(scene.side)));
  const double filling = tally([&] {
    const Tallied p = -frame * frame, q = -frame;
    Tallied sum = 0;
    scene.jacobian(s.x, s.v, 0.0,
                   [&](int, int, Tallied dadx, Tallied dadv) { sum += p * dadx + q * dadv; });
  });
  return filling + work_of_substep(scene) + double(s.x.size()) + work_of_solving(factor);
}

/// Where the matrices of chain, rope and cloth are not zero.
inline void matrices(measure::Record& record) {
  const auto pattern = [&](const char* name, const Sparse& matrix) {
    auto& table = record.table(name, {{"column", "", measure::whole}, {"row", "", measure::whole}});
    for (int j = 0; j < matrix.cols(); ++j) {
      for (Sparse::InnerIterator entry(matrix, j); entry; ++entry) {
        table.add({double(j), double(entry.row())});
      }
    }
  };
  pattern("chain", step_matrix_of(chain));
  pattern("rope", step_matrix_of(rope));
  pattern("cloth", step_matrix_of(cloth));
  pattern("factor", factor_of(step_matrix_of(cloth)));
  record.number("chain-entries", double(step_matrix_of(chain).nonZeros()), measure::whole);
  record.number("factor-entries", double(factor_of(step_matrix_of(cloth)).nonZeros()),
                measure::whole);
  record.number("chain-places", double(chain.count) * chain.count, measure::whole);
  record.number("unknowns", double(chain.count), measure::whole);
}

/// What a frame costs, solved and in substeps.
inline void costs(measure::Record& record) {
  auto& table = record.table("work", {{"scene"},
                                      {"unknowns", "", measure::whole},
                                      {"entries of the factor, each", "", 2},
                                      {"solving", "", 2},
                                      {"substeps", "", measure::whole},
                                      {"all substeps", "", 2}});
  const auto add = [&](const std::string& name, const auto& scene, const auto& tallied) {
    const double n = double(scene.start().x.size());
    const int substeps = substeps_for(scene);
    table.add({name, n, double(factor_of(step_matrix_of(scene)).nonZeros()) / n,
               work_of_step(tallied) / n, double(substeps),
               substeps * work_of_substep(tallied) / n});
  };
  for (const int count : {108, 972, 10'092}) {
    add("chain", chain_of(count), chain_of<Tallied>(count));
  }
  for (const int count : {36, 324, 3364}) {
    add("rope", rope_of(count), rope_of<Tallied>(count));
  }
  for (const int side : {6, 10, 18, 32, 58}) {
    const std::string sides = std::to_string(side);
    add("cloth " + sides + " × " + sides, cloth_of(side), cloth_of<Tallied>(side));
  }
  const auto ratio = [&](std::size_t row) {
    return table.rows[row][5].value / table.rows[row][3].value;
  };
  record.number("chain-wins", ratio(0), 2);
  record.number("rope-wins", ratio(3), 2);
  record.number("cloth-level-solved", table.rows[8][3].value, 2);
  record.number("cloth-level-stepped", table.rows[8][5].value, 2);
  record.number("cloth-loses", 1 / ratio(10), 2);
  record.number("factor-small", table.rows[6][2].value, 2);
  record.number("factor-large", table.rows[10][2].value, 2);
}

/// The same for a rope on a nail, over the stiffness of its springs.
inline void costs_on_a_nail(measure::Record& record) {
  auto& table = record.table("nail", {{"stiffness", "N/m", measure::whole},
                                      {"substeps", "", measure::whole},
                                      {"all substeps", "", measure::whole},
                                      {"solving", "", measure::whole}});
  const auto row = [](double stiffness) -> std::vector<measure::Cell> {
    const auto counted = rope_on_a_nail<Tallied>(stiffness);
    const double substeps = substeps_for(rope_on_a_nail(stiffness));
    return {stiffness, substeps, substeps * work_of_substep(counted), work_of_step(counted)};
  };
  for (int n = 0; n <= 148; ++n) table.add(row(100 * std::pow(10, n / 40.0)));
  const auto ten = row(1e4);
  record.number("nail-substeps", ten[1].value, measure::whole);
  record.number("nail-stepped", ten[2].value, measure::whole);
  record.number("nail-solved", ten[3].value, measure::whole);
}
