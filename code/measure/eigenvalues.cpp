// SPDX-License-Identifier: MIT-0
#include "measure/eigenvalues.h"

#include <Eigen/Eigenvalues>

namespace measure {

Eigen::VectorXcd eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  return Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues();
}

double largest_eigenvalue(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  return eigenvalues(matrix).cwiseAbs().maxCoeff();
}

}  // namespace measure
