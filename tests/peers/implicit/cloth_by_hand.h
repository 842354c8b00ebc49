// SPDX-License-Identifier: MIT-0
// An implicit step of a cloth with plain calls of Eigen, written for this one scene: the place of
// each entry is looked up beforehand, and only the half of the matrix that Eigen reads is filled.
#pragma once
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <vector>

#include "implicit/variants.h"
#include "scenes/cloth.h"

namespace implicit::by_hand {

/// Without damping and gravity.
class Cloth {
 public:
  explicit Cloth(const scenes::Cloth<>& cloth)
      : cloth_(cloth), matrix_(3 * cloth.nodes(), 3 * cloth.nodes()), rest_(3 * cloth.nodes()) {
    find_pattern();
    cloth.for_each_link([&](int i, int j, const auto& link) {
      springs_.push_back({i, j, link, columns_of(i, i), columns_of(j, j), columns_of(j, i)});
    });
    for (int i = 0; i < 3 * cloth.nodes(); ++i) diagonal_.push_back(place(i, i));
    solver_.analyzePattern(matrix_);
  }
  Cloth(const Cloth& other) : Cloth(other.cloth_) {}

  void operator()(State& s, double step) {
    assemble(s, step);
    solver_.factorize(matrix_);
    s.v += solver_.solve(rest_);
    s.x += step * s.v;
  }

 private:
  using Places = std::array<double*, 3>;  // of the columns of a block; null if a node is held

  // In the matrix: the blocks of the nodes i and j, and that of row j and column i.
  struct Spring {
    int i, j;
    scenes::Link<> link;
    Places at_i, at_j, between;
  };

  bool is_held(int i, int j) const { return cloth_.held(i) || cloth_.held(j); }
  double* place(int row, int column) { return &matrix_.coeffRef(row, column); }

  void find_pattern() {
    std::vector<Eigen::Triplet<double>> entries;
    const auto add_block = [&](int j, int i) {
      for (int row = 3 * j; row < 3 * j + 3; ++row) {
        for (int column = 3 * i; column < 3 * i + 3; ++column) {
          if (row >= column) entries.emplace_back(row, column, 0.0);
        }
      }
    };
    for (int i = 0; i < cloth_.nodes(); ++i) add_block(i, i);
    cloth_.for_each_link([&](int i, int j, const auto&) {
      if (!is_held(i, j)) add_block(j, i);
    });
    matrix_.setFromTriplets(entries.begin(), entries.end());
  }

  // Of a block on the diagonal, the columns begin there.
  Places columns_of(int j, int i) {
    if (is_held(i, j)) return {};
    const auto column = [&](int n) { return place(i == j ? 3 * j + n : 3 * j, 3 * i + n); };
    return {column(0), column(1), column(2)};
  }

  void assemble(const State& s, double step) {
    std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
    for (double* one : diagonal_) *one = 1;
    x_end_ = s.x + step * s.v;
    rest_.setZero();
    const double weight = step / cloth_.mass;
    for (const Spring& spring : springs_) {
      const Eigen::Vector3d d = x_end_.segment<3>(3 * spring.j) - x_end_.segment<3>(3 * spring.i);
      const Eigen::Vector3d pull = weight * spring.link.pull(d, Eigen::Vector3d::Zero());
      rest_.segment<3>(3 * spring.i) += pull;
      rest_.segment<3>(3 * spring.j) -= pull;
      add(step * weight * spring.link.stiffness(d), spring);
    }
    for (const int corner : {0, cloth_.side - 1}) rest_.segment<3>(3 * corner).setZero();
  }

  static void add(const Eigen::Matrix3d& block, const Spring& spring) {
    for (int column = 0; column < 3; ++column) {
      const auto n = std::size_t(column);
      for (int row = column; row < 3; ++row) {
        if (spring.at_i[n]) spring.at_i[n][row - column] += block(row, column);
        if (spring.at_j[n]) spring.at_j[n][row - column] += block(row, column);
      }
      if (!spring.between[n]) continue;
      for (int row = 0; row < 3; ++row) spring.between[n][row] -= block(row, column);
    }
  }

  scenes::Cloth<> cloth_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  std::vector<Spring> springs_;
  std::vector<double*> diagonal_;
  Eigen::VectorXd x_end_, rest_;
};

}  // namespace implicit::by_hand
