// SPDX-License-Identifier: MIT-0
#pragma once
#include <Eigen/Core>

// Three numbers in a vector or an array, of fixed or of dynamic size.
template <class Vector>
struct EigenVectors {
  using Vec = Vector;
  using Real = typename Vec::Scalar;
  using Time = double;
  static constexpr int size = 3;
  static constexpr const char* name = Vec::SizeAtCompileTime == Eigen::Dynamic
                                          ? "a dynamic vector of Eigen's"
                                          : "a fixed vector of Eigen's";
  static Vec make(const Real* from) { return Eigen::Map<const Vec>(from, size); }
  static Real read(const Vec& x, int i) { return x[i]; }
};
