// SPDX-License-Identifier: MIT-0
// Eigen::Vector3f.
#pragma once
#include <Eigen/Core>

namespace kinds {

struct eigen_vector3f {
  using Vec = Eigen::Vector3f;
  using Real = float;
  using Time = double;
  static constexpr int size = 3;
  static constexpr const char* name = "Eigen::Vector3f";
  static Vec make(const Real* from) { return Vec(from[0], from[1], from[2]); }
  static Real read(const Vec& x, int i) { return x[i]; }
};

}  // namespace kinds
