// SPDX-License-Identifier: MIT-0
#include "systems_try.h"

#include <Eigen/LU>

namespace systems {

Solution solve_with_full_pivoting(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return {matrix.fullPivLu().solve(right), matrix.norm() * matrix.inverse().norm()};
}

}  // namespace systems
