// SPDX-License-Identifier: MIT-0
/// @file
/// The linear system of an implicit step, sparse: for cloth.
#pragma once
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace integrate {

// [system]
/// A system of many unknowns with few neighbours each, in no order: cloth.
///
/// Sparse Cholesky, its symbolic part once for as long as the Jacobian adds the same entries in the
/// same order. The matrix must be symmetric and positive definite, which is checked: of a Jacobian
/// that isn't symmetric, Eigen would read one half and give a wrong answer without a word.
/// Unequal masses make it so; with the masses given, the rows are multiplied by them, and it is
/// symmetric again.
/// @tparam Jacobian  callable `(x, v, t, add)` that calls `add(i, j, dadx, dadv)` for every entry
/// that is not zero: the derivative of acceleration i by position j [1/s^2] and by velocity j [1/s]
/// @tparam Real  `double` or `float`
template <class Jacobian, class Real = double>
class SparseSystem {
 public:
  using Vec = Eigen::Matrix<Real, Eigen::Dynamic, 1>;  ///< all unknowns

  /// Takes the Jacobian of the acceleration.
  /// @param jacobian  see above
  /// @param masses  one for each unknown; none if they are equal
  explicit SparseSystem(Jacobian jacobian, Vec masses = {})
      : jacobian_(std::move(jacobian)), masses_(std::move(masses)) {}

  /// Solves (1 + p da/dx + q da/dv) y = change, and puts y into `change`.
  /// @returns  false if the matrix is not symmetric or not positive definite; problem() says which
  template <class Time>
  bool operator()(const Vec& x, const Vec& v, Time t, Real p, Real q, Vec& change) {
    if (!fill(x, v, t, p, q)) {
      find_pattern(x, v, t);
      fill(x, v, t, p, q);
    }
    problem_ = "the matrix is not symmetric: give the masses, or use a DenseSystem";
    if (!symmetric()) return false;
    problem_ = "the matrix is not positive definite: take a smaller step";
    solver_.factorize(matrix_);
    if (solver_.info() != Eigen::Success || !(solver_.vectorD().array() > 0).all()) return false;
    problem_ = "";
    if (masses_.size() > 0) change = masses_.cwiseProduct(change);
    change = solver_.solve(change).eval();
    return true;
  }

  /// What went wrong in the last solve and what to do; empty if nothing did.
  const char* problem() const { return problem_; }

 private:
  using Matrix = Eigen::SparseMatrix<Real>;

  Real mass(Eigen::Index i) const { return masses_.size() > 0 ? masses_[i] : Real(1); }

  // The whole matrix, each entry into its place; false if there is an entry without one.
  template <class Time>
  bool fill(const Vec& x, const Vec& v, Time t, Real p, Real q) {
    if (matrix_.rows() != x.size()) return false;
    Real* const values = matrix_.valuePtr();
    std::fill_n(values, matrix_.nonZeros(), Real(0));
    for (Eigen::Index i = 0; i < x.size(); ++i) values[place(i, i)] = mass(i);
    std::size_t next = 0;
    bool known = true;
    jacobian_(x, v, t, [&](Eigen::Index i, Eigen::Index j, Real dadx, Real dadv) {
      known = known && next < places_.size() && is_place_of(places_[next], i, j);
      if (known) values[places_[next++]] += mass(i) * (p * dadx + q * dadv);
    });
    return known && next == places_.size();
  }

  // Every entry that the Jacobian adds, its mirror image and the diagonal.
  template <class Time>
  void find_pattern(const Vec& x, const Vec& v, Time t) {
    std::vector<Eigen::Triplet<Real>> entries, mirrored;
    jacobian_(x, v, t, [&](Eigen::Index i, Eigen::Index j, Real, Real) {
      entries.emplace_back(int(i), int(j), Real(0));
    });
    for (const auto& entry : entries) mirrored.emplace_back(entry.col(), entry.row(), Real(0));
    for (int i = 0; i < int(x.size()); ++i) mirrored.emplace_back(i, i, Real(0));
    mirrored.insert(mirrored.end(), entries.begin(), entries.end());
    matrix_.resize(x.size(), x.size());
    matrix_.setFromTriplets(mirrored.begin(), mirrored.end());
    places_.clear();
    for (const auto& entry : entries) places_.push_back(place(entry.row(), entry.col()));
    mirror_.clear();
    for (int j = 0; j < int(x.size()); ++j) {
      for (typename Matrix::InnerIterator entry(matrix_, j); entry; ++entry) {
        mirror_.push_back(place(j, entry.row()));
      }
    }
    solver_.analyzePattern(matrix_);
  }

  bool is_place_of(int place, Eigen::Index i, Eigen::Index j) const {
    const int* const columns = matrix_.outerIndexPtr();
    return matrix_.innerIndexPtr()[place] == i && place >= columns[j] && place < columns[j + 1];
  }

  int place(Eigen::Index i, Eigen::Index j) const {
    const int* const rows = matrix_.innerIndexPtr();
    const int* const columns = matrix_.outerIndexPtr();
    return int(std::lower_bound(rows + columns[j], rows + columns[j + 1], i) - rows);
  }

  // Up to rounding, which may differ between an entry and its mirror image.
  bool symmetric() const {
    const Real* const values = matrix_.valuePtr();
    const Real rounding = std::sqrt(std::numeric_limits<Real>::epsilon());
    for (std::size_t n = 0; n < mirror_.size(); ++n) {
      const Real here = values[n], there = values[mirror_[n]];
      if (!(std::abs(here - there) <= rounding * std::max(std::abs(here), std::abs(there)))) {
        return false;
      }
    }
    return true;
  }

  Jacobian jacobian_;
  Vec masses_;
  Matrix matrix_;
  Eigen::SimplicialLDLT<Matrix> solver_;
  std::vector<int> places_;  // of the entries in matrix_, in the order in which they are added
  std::vector<int> mirror_;  // of each entry of matrix_, the place on the other side
  const char* problem_ = "";
};
// [system]

}  // namespace integrate
