// SPDX-License-Identifier: MIT-0
// For the tests of the linear systems: what they should answer, and right sides to ask for.
#pragma once
#include <Eigen/Core>
#include <limits>
#include <vector>

namespace systems {

template <class Real>
using Many = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

// The derivatives of a scene, in the form that the systems take.
template <class Scene>
auto jacobian_of(const Scene& scene) {
  return
      [&scene](const auto& x, const auto& v, auto t, auto&& add) { scene.jacobian(x, v, t, add); };
}

// Derivatives that a test can change while a system uses them.
struct Entry {
  int row, column;
  double dadx, dadv = 0;
};
struct Entries {
  const std::vector<Entry>* all;

  template <class Vec, class Time, class Add>
  void operator()(const Vec&, const Vec&, Time, Add&& add) const {
    using Real = typename Vec::Scalar;
    for (const Entry& each : *all) add(each.row, each.column, Real(each.dadx), Real(each.dadv));
  }
};

// Numbers between 0 and 1 without an order, by the logistic map.
template <class Vec>
Vec mixed(Vec all, typename Vec::Scalar seed) {
  using Real = typename Vec::Scalar;
  for (Real& each : all) each = seed = Real(3.9) * seed * (Real(1) - seed);
  return all;
}

// The solution of (1 + p da/dx + q da/dv) y = change by elimination with full pivoting, in double,
// and how far single roundings of the matrix can move it.
template <class Vec>
struct Answer {
  Vec y;
  double rounding;
};

// The same of a matrix; the compiler takes long for it.
struct Solution {
  Eigen::VectorXd y;
  double condition;
};
Solution solve_with_full_pivoting(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

template <class Vec, class Jacobian>
Answer<Vec> full_pivot(const Jacobian& jacobian, const Vec& x, const Vec& v, double p, double q,
                       const Vec& change) {
  using Real = typename Vec::Scalar;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(x.size(), x.size());
  jacobian(x, v, Real(0), [&](Eigen::Index i, Eigen::Index j, Real dadx, Real dadv) {
    matrix(i, j) += p * double(dadx) + q * double(dadv);
  });
  const auto [y, condition] = solve_with_full_pivoting(matrix, change.template cast<double>());
  const double epsilon = double(std::numeric_limits<Real>::epsilon());
  return {y.template cast<Real>(), 4 * epsilon * condition * y.norm()};
}

// Whether 1 - da/dx can be inverted, in the opinion of a system of so many unknowns.
template <class System>
bool solved(System& system, int size, double right_side = 1) {
  using Vec = typename System::Vec;
  using Real = typename Vec::Scalar;
  const Vec x = Vec::Zero(size);
  Vec change = Vec::Constant(size, Real(right_side));
  return system(x, x, Real(0), Real(-1), Real(0), change);
}

// Whether it can, and what comes out is right.
template <class System>
bool solves(System& system, const std::vector<Entry>& entries, int size) {
  const Eigen::VectorXd x = Eigen::VectorXd::Zero(size);
  Eigen::VectorXd change = mixed(x, 0.3);
  const auto [y, rounding] = full_pivot(Entries{&entries}, x, x, -1, -0.5, change);
  return system(x, x, 0.0, -1.0, -0.5, change) && (change - y).norm() <= rounding;
}

}  // namespace systems
