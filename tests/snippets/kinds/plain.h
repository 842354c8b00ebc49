// SPDX-License-Identifier: MIT-0
// A plain struct of floats.
#pragma once
namespace kinds {

struct PlainFloats {
  float x, y, z;
};
constexpr PlainFloats operator+(PlainFloats p, PlainFloats q) {
  return {p.x + q.x, p.y + q.y, p.z + q.z};
}
constexpr PlainFloats operator*(float s, PlainFloats p) {
  return {s * p.x, s * p.y, s * p.z};
}

struct plain {
  using Vec = PlainFloats;
  using Real = float;
  using Time = double;
  static constexpr int size = 3;
  static constexpr const char* name = "a plain struct of floats";
  static Vec make(const Real* from) { return {from[0], from[1], from[2]}; }
  static Real read(const Vec& x, int i) { return i == 0 ? x.x : i == 1 ? x.y : x.z; }
};

}  // namespace kinds
