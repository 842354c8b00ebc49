// SPDX-License-Identifier: MIT-0
// glm::vec3.
#pragma once
#include <glm/vec3.hpp>

namespace kinds {

struct glm_vec3 {
  using Vec = glm::vec3;
  using Real = float;
  using Time = double;
  static constexpr int size = 3;
  static constexpr const char* name = "glm::vec3";
  static Vec make(const Real* from) { return {from[0], from[1], from[2]}; }
  static Real read(const Vec& x, int i) { return x[i]; }
};

}  // namespace kinds
