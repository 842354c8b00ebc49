// SPDX-License-Identifier: MIT-0
// Derivatives by differences, to compare those of a scene with.
#pragma once
#include <Eigen/Core>
#include <limits>
#include <random>

#include "equation.h"

namespace differences {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Numbers between -size and size.
inline VectorXd random(Eigen::Index count, double size, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> number(-size, size);
  VectorXd all(count);
  for (double& one : all) one = number(engine);
  return all;
}

struct Slopes {
  MatrixXd matrix;  // a column for each number in x
  double rounding;  // how wrong an entry may be
};

// The derivatives of a vector by a vector. The weights of the differences add up to 2.1 for each
// thousandth of a step; the vectors are right to some ten roundings, and x itself to one.
template <class F>
Slopes slopes(F f, const VectorXd& x) {
  const VectorXd middle = f(x);
  MatrixXd matrix(middle.size(), x.size());
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const auto moved = [&](long double by) {
      const VectorXd there = x + double(by) * VectorXd::Unit(x.size(), j);
      return Eigen::VectorX<long double>(VectorXd(f(there)).cast<long double>());
    };
    matrix.col(j) = equation::slope(moved, 0).template cast<double>();
  }
  const auto largest = [](const auto& all) { return all.cwiseAbs().maxCoeff(); };
  const double of_f = 10 * largest(middle) + largest(matrix) * largest(x);
  return {matrix, 2100 * std::numeric_limits<double>::epsilon() * of_f};
}

// The derivatives of a number by a vector.
template <class F>
Slopes gradient(F f, const VectorXd& x) {
  return slopes([&](const VectorXd& there) { return VectorXd::Constant(1, f(there)); }, x);
}

}  // namespace differences
