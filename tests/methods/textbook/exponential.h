// SPDX-License-Identifier: MIT-0
// The exponential of a matrix: its series for a small part of it, squared again and again.
#pragma once
#include <Eigen/Core>

#include "problem.h"

namespace textbook {

using Matrix = Eigen::Matrix<Real, 2, 2>;
using Pair = Eigen::Matrix<Real, 2, 1>;  // position and velocity, or a velocity and what pushes it

inline Matrix exponential(const Matrix& matrix) {
  int halvings = 0;
  Matrix part = matrix;
  for (; part.norm() > 0.5L; part /= 2) ++halvings;
  Matrix sum = Matrix::Identity();
  for (int n = 20; n >= 1; --n) sum = Matrix::Identity() + part * sum / Real(n);
  for (; halvings > 0; --halvings) sum = Matrix(sum * sum);
  return sum;
}

}  // namespace textbook
