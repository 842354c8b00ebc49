// SPDX-License-Identifier: MIT-0
#include "matrix_costs.h"

#include <Eigen/SparseCholesky>
#include <cmath>
#include <string>
#include <vector>

Sparse factor_of(const Sparse& matrix) {
  return Eigen::SimplicialLDLT<Sparse>(matrix).matrixL().nestedExpression();
}

// Entries that stand below one another in a column make one row of the table.
static void add_runs(measure::Table& table, const Sparse& matrix) {
  for (int column = 0; column < matrix.cols(); ++column) {
    Sparse::InnerIterator entry(matrix, column);
    while (entry) {
      const auto from = entry.row();
      auto to = from;
      while (++entry && entry.row() == to + 1) ++to;
      table.add({double(column), double(from), double(to)});
    }
  }
}

void matrices(measure::Record& record) {
  const auto pattern = [&](const char* name, const Sparse& matrix) {
    add_runs(record.table(name, {{"column", "", measure::whole},
                                 {"from row", "", measure::whole},
                                 {"to row", "", measure::whole}}),
             matrix);
  };
  pattern("chain", step_matrix_of(steel_chain));
  pattern("rope", step_matrix_of(steel_rope));
  pattern("cloth", step_matrix_of(steel_cloth));
  pattern("factor", factor_of(step_matrix_of(steel_cloth)));
  record.number("chain-entries", double(step_matrix_of(steel_chain).nonZeros()), measure::whole);
  record.number("factor-entries", double(factor_of(step_matrix_of(steel_cloth)).nonZeros()),
                measure::whole);
  record.number("chain-places", double(steel_chain.count) * steel_chain.count, measure::whole);
  record.number("unknowns", double(steel_chain.count), measure::whole);
}

void costs(measure::Record& record) {
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
    add("chain", chain_of(count), chain_of<OpCounted>(count));
  }
  for (const int count : {36, 324, 3364}) {
    add("rope", rope_of(count), rope_of<OpCounted>(count));
  }
  for (const int side : {6, 10, 18, 32, 58}) {
    const std::string sides = std::to_string(side);
    add("cloth " + sides + " × " + sides, cloth_of(side), cloth_of<OpCounted>(side));
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

void costs_on_a_nail(measure::Record& record) {
  auto& table = record.table("nail", {{"stiffness", "N/m", measure::whole},
                                      {"substeps", "", measure::whole},
                                      {"all substeps", "", measure::whole},
                                      {"solving", "", measure::whole}});
  const auto row = [](double stiffness) -> std::vector<measure::Cell> {
    const auto counted = rope_on_a_nail<OpCounted>(stiffness);
    const double substeps = substeps_for(rope_on_a_nail(stiffness));
    return {stiffness, substeps, substeps * work_of_substep(counted), work_of_step(counted)};
  };
  for (int n = 0; n <= 148; ++n) table.add(row(100 * std::pow(10, n / 40.0)));
  const auto ten = row(1e4);
  record.number("nail-substeps", ten[1].value, measure::whole);
  record.number("nail-stepped", ten[2].value, measure::whole);
  record.number("nail-solved", ten[3].value, measure::whole);
}
