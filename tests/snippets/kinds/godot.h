// SPDX-License-Identifier: MIT-0
// Godot 4: Vector3 of real_t, which is float, with its operators as members.
#pragma once

namespace kinds {

using real_t = float;

struct GodotVector3 {
  real_t coord[3] = {0, 0, 0};

  constexpr GodotVector3() {}
  constexpr GodotVector3(real_t px, real_t py, real_t pz) : coord{px, py, pz} {}
  constexpr GodotVector3 operator+(const GodotVector3& q) const {
    return {coord[0] + q.coord[0], coord[1] + q.coord[1], coord[2] + q.coord[2]};
  }
  constexpr GodotVector3 operator*(const GodotVector3& q) const {
    return {coord[0] * q.coord[0], coord[1] * q.coord[1], coord[2] * q.coord[2]};
  }
  constexpr GodotVector3 operator*(real_t s) const {
    return {coord[0] * s, coord[1] * s, coord[2] * s};
  }
};
constexpr GodotVector3 operator*(real_t s, const GodotVector3& p) {
  return p * s;
}

struct godot {
  using Vec = GodotVector3;
  using Real = float;
  using Time = double;
  static constexpr int size = 3;
  static constexpr const char* name = "Godot’s Vector3";
  static Vec make(const Real* from) { return {from[0], from[1], from[2]}; }
  static Real read(const Vec& x, int i) { return x.coord[i]; }
};

}  // namespace kinds
