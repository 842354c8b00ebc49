// SPDX-License-Identifier: MIT-0
// DirectXMath and its like: four floats in one register, of which a vector uses three.
#pragma once

namespace kinds {

// Aligned, passed by value, and made by functions alone.
struct alignas(16) Register {
  float lanes[4];
};
inline Register set(float x, float y, float z) {
  return {{x, y, z, 0}};
}
inline Register operator+(Register p, Register q) {
  for (int i = 0; i < 4; ++i) p.lanes[i] += q.lanes[i];
  return p;
}
inline Register operator*(float s, Register p) {
  for (int i = 0; i < 4; ++i) p.lanes[i] *= s;
  return p;
}

struct directx {
  using Vec = Register;
  using Real = float;
  using Time = double;
  static constexpr int size = 3;
  static constexpr const char* name = "a SIMD register of four floats";
  static Vec make(const Real* from) { return set(from[0], from[1], from[2]); }
  static Real read(const Vec& x, int i) { return x.lanes[i]; }
};

}  // namespace kinds
