// SPDX-License-Identifier: MIT-0
/// @file
/// The linear system of an implicit step, sparse: for cloth.
///
/// @code
/// #include "backward_euler.h"
///
/// // A chain between two walls: each mass is pulled by both of its neighbours.
/// const auto pull = [](const Eigen::VectorXd& x, const Eigen::VectorXd&, double) {
///   Eigen::VectorXd a = -2e4 * x;
///   a.head(x.size() - 1) += 1e4 * x.tail(x.size() - 1);
///   a.tail(x.size() - 1) += 1e4 * x.head(x.size() - 1);
///   return a;
/// };
/// const auto jacobian = [](const Eigen::VectorXd& x, const auto&, double, auto&& add) {
///   for (int i = 0; i < x.size(); ++i) add(i, i, -2e4, 0.0);
///   for (int i = 1; i < x.size(); ++i) add(i, i - 1, 1e4, 0.0);
///   for (int i = 1; i < x.size(); ++i) add(i - 1, i, 1e4, 0.0);
/// };
/// integrate::SparseSystem<decltype(jacobian)> system(jacobian);
/// Eigen::VectorXd x = Eigen::VectorXd::Unit(100, 50), v = Eigen::VectorXd::Zero(100);
/// const bool solved = integrate::backward_euler(x, v, 0.0, 1 / 60.0, pull, system);
/// @endcode
#pragma once
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace integrate {

/// A system of many unknowns with few neighbours each, in no order: cloth.
///
/// Sparse Cholesky, its symbolic part once for as long as the Jacobian adds the same entries in the
/// same order. The matrix must be symmetric and positive definite, which is checked: of a Jacobian
/// that isn't symmetric, Eigen would read one half and give a wrong answer without a word.
/// Unequal masses make it so; with the masses given, the rows are multiplied by them, and it is
/// symmetric again. It holds Eigen's solver, which can be neither copied nor moved: make it where
/// it will live.
/// @tparam Jacobian  callable `(x, v, t, add)` that calls `add(i, j, dadx, dadv)` for every entry
/// that is not zero: the derivative of acceleration i by position j [1/s^2] and by velocity j
/// [1/s]; i and j count from 0
/// @tparam Real  `double` or `float`
template <class Jacobian, class Real = double>
class SparseSystem {
 public:
  using Vec = Eigen::Matrix<Real, Eigen::Dynamic, 1>;  ///< all unknowns

  /// Takes the Jacobian of the acceleration.
  /// @param jacobian  see above
  /// @param masses  one for each unknown, more than zero [kg]; none if they are equal
  explicit SparseSystem(Jacobian jacobian, Vec masses = {})
      : jacobian_(std::move(jacobian)), masses_(std::move(masses)) {
    solver_.analyzePattern(matrix_);  // of no unknowns yet, and that may be all there will be
  }

  /// Solves (1 + p da/dx + q da/dv) y = change, and puts y into `change`.
  /// @returns  false if it could not; problem() says why
  template <class Time>
  bool operator()(const Vec& x, const Vec& v, Time t, Real p, Real q, Vec& change) {
    problem_ = factorize(x, v, t, p, q);
    if (*problem_ != 0) return false;
    if (masses_.size() > 0) change = masses_.cwiseProduct(change);
    change = solver_.solve(change).eval();
    if (!finite(change.data(), change.size())) {
      problem_ = "the change that was asked for is not finite";
    }
    return *problem_ == 0;
  }

  /// What went wrong in the last solve and what to do; empty if nothing did.
  const char* problem() const { return problem_; }

 private:
  using Matrix = Eigen::SparseMatrix<Real>;

  // Where in the matrix an entry goes that the Jacobian adds.
  struct Entry {
    int row, column, place;
  };

  // Two places in the matrix that mirror each other in the diagonal.
  struct Pair {
    int row, column, below, above;
  };

  // What is wrong with the matrix; empty if nothing is.
  template <class Time>
  const char* factorize(const Vec& x, const Vec& v, Time t, Real p, Real q) {
    if (masses_.size() > 0 && masses_.size() != x.size()) return "give one mass for each unknown";
    if (!fill(x, v, t, p, q)) {
      find_pattern(x, v, t);
      if (!fill(x, v, t, p, q)) return "the Jacobian must add the same entries if called again";
    }
    if (!finite(matrix_.valuePtr(), matrix_.nonZeros())) {
      return "the Jacobian or a mass is not finite";
    }
    if (!symmetric()) return "the matrix is not symmetric: give the masses, or use a DenseSystem";
    solver_.factorize(matrix_);
    const bool positive = solver_.info() == Eigen::Success && (solver_.vectorD().array() > 0).all();
    return positive ? "" : "the matrix is not positive definite: take a smaller step";
  }

  Real mass(Eigen::Index i) const { return masses_.size() > 0 ? masses_[i] : Real(1); }

  // The whole matrix, each entry into its place; false if there is an entry without one.
  template <class Time>
  bool fill(const Vec& x, const Vec& v, Time t, Real p, Real q) {
    if (matrix_.rows() != x.size()) return false;
    Real* const values = matrix_.valuePtr();
    std::fill_n(values, matrix_.nonZeros(), Real(0));
    for (Eigen::Index i = 0; i < x.size(); ++i) values[diagonal_[std::size_t(i)]] = mass(i);
    std::size_t next = 0;
    bool known = true;
    jacobian_(x, v, t, [&](Eigen::Index i, Eigen::Index j, Real dadx, Real dadv) {
      known =
          known && next < entries_.size() && entries_[next].row == i && entries_[next].column == j;
      if (known) values[entries_[next++].place] += mass(i) * (p * dadx + q * dadv);
    });
    return known && next == entries_.size();
  }

  // Every entry that the Jacobian adds, its mirror image and the diagonal.
  template <class Time>
  void find_pattern(const Vec& x, const Vec& v, Time t) {
    entries_.clear();
    jacobian_(x, v, t, [&](Eigen::Index i, Eigen::Index j, Real, Real) {
      entries_.push_back({int(i), int(j), 0});
    });
    std::vector<Eigen::Triplet<Real>> all;
    for (int i = 0; i < int(x.size()); ++i) all.emplace_back(i, i, Real(0));
    for (const Entry& entry : entries_) {
      all.emplace_back(entry.row, entry.column, Real(0));
      all.emplace_back(entry.column, entry.row, Real(0));
    }
    matrix_.resize(x.size(), x.size());
    matrix_.setFromTriplets(all.begin(), all.end());
    solver_.analyzePattern(matrix_);

    for (Entry& entry : entries_) entry.place = place(entry.row, entry.column);
    diagonal_.clear();
    pairs_.clear();
    for (int j = 0; j < int(x.size()); ++j) {
      diagonal_.push_back(place(j, j));
      for (typename Matrix::InnerIterator entry(matrix_, j); entry; ++entry) {
        const int i = int(entry.row());
        if (i > j) pairs_.push_back({i, j, place(i, j), place(j, i)});
      }
    }
  }

  int place(int i, int j) const {
    const int* const rows = matrix_.innerIndexPtr();
    const int* const columns = matrix_.outerIndexPtr();
    return int(std::lower_bound(rows + columns[j], rows + columns[j + 1], i) - rows);
  }

  // Up to half of the digits, for a Jacobian by differences; and up to some hundred roundings of
  // the diagonal, since an entry may be a sum of many, none larger than that, which cancel.
  bool symmetric() const {
    const Real* const values = matrix_.valuePtr();
    const auto size = [&](int place) { return std::abs(values[place]); };
    const auto diagonal = [&](int i) { return size(diagonal_[std::size_t(i)]); };
    const Real rounding = std::numeric_limits<Real>::epsilon();
    for (const Pair& pair : pairs_) {
      const Real difference = std::abs(values[pair.below] - values[pair.above]);
      const Real entry = (std::max)(size(pair.below), size(pair.above));
      const Real terms = diagonal(pair.row) + diagonal(pair.column);
      if (difference > std::sqrt(rounding) * entry + 100 * rounding * terms) return false;
    }
    return true;
  }

  // By their bits, since -ffast-math takes every number for finite: one more in an exponent of ones
  // carries over into the sign.
  static bool finite(const Real* numbers, Eigen::Index count) {
    using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
    static_assert(sizeof(Bits) == sizeof(Real), "Real must be double or float");
    constexpr Bits one = Bits(1) << (sizeof(Real) == 4 ? 23 : 52);
    constexpr Bits sign = ~(~Bits(0) >> 1);
    Bits carried = 0;
    for (Eigen::Index n = 0; n < count; ++n) {
      Bits bits;
      std::memcpy(&bits, numbers + n, sizeof bits);
      carried |= (bits & (sign - one)) + one;
    }
    return carried < sign;
  }

  Jacobian jacobian_;
  Vec masses_;
  Matrix matrix_;
  Eigen::SimplicialLDLT<Matrix> solver_;
  std::vector<Entry> entries_;  // in the order in which they are added
  std::vector<int> diagonal_;   // places of the diagonal
  std::vector<Pair> pairs_;     // all places beside the diagonal
  const char* problem_ = "";
};

}  // namespace integrate
