// SPDX-License-Identifier: MIT-0
// raylib 5.5: raymath.h has Vector3 * float, and not float * Vector3, which its users add.
#pragma once

namespace kinds {

struct Vector3 {
  float x, y, z;
};
// As raymath.h has them.
inline Vector3 operator+(const Vector3& p, const Vector3& q) {
  return {p.x + q.x, p.y + q.y, p.z + q.z};
}
inline Vector3 operator-(const Vector3& p, const Vector3& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}
inline Vector3 operator*(const Vector3& p, const float& s) {
  return {p.x * s, p.y * s, p.z * s};
}
inline Vector3 operator*(const Vector3& p, const Vector3& q) {
  return {p.x * q.x, p.y * q.y, p.z * q.z};
}
// The one that is missing, as the pages of the headers print it.
inline Vector3 operator*(float s, Vector3 v) {
  return v * s;
}

struct raylib {
  using Vec = Vector3;
  using Real = float;
  using Time = double;
  static constexpr int size = 3;
  static constexpr const char* name = "raylib";
  static Vec make(const Real* from) { return {from[0], from[1], from[2]}; }
  static Real read(const Vec& x, int i) { return i == 0 ? x.x : i == 1 ? x.y : x.z; }
};

}  // namespace kinds
