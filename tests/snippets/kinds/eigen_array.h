// SPDX-License-Identifier: MIT-0
// Many bodies in one Eigen::Array; three stand for them.
#pragma once
#include <Eigen/Core>

namespace kinds {

struct eigen_array {
  using Vec = Eigen::ArrayXd;
  using Real = double;
  using Time = double;
  static constexpr int size = 3;
  static constexpr const char* name = "Eigen::ArrayXd";
  static Vec make(const Real* from) { return Eigen::Array3d(from[0], from[1], from[2]); }
  static Real read(const Vec& x, int i) { return x[i]; }
};

}  // namespace kinds
