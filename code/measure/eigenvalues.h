// SPDX-License-Identifier: MIT-0
/// @file
/// The eigenvalues of a small matrix of real numbers.
#pragma once
#include <Eigen/Core>
#include <complex>

namespace measure {

/// The eigenvalues of a square matrix, each as often as it is a root, by Eigen's EigenSolver.
///
/// Compiled once, for any number of rows: a compiler takes eight seconds for each size.
Eigen::VectorXcd eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

/// The size of the eigenvalue that is largest.
double largest_eigenvalue(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

}  // namespace measure
