// SPDX-License-Identifier: MIT-0
// Chipmunk 7: chipmunk.h has cpVect * cpFloat, and not cpFloat * cpVect, which its users add.
#pragma once

namespace kinds {

using cpFloat = double;

struct cpVect {
  cpFloat x, y;
};
// As chipmunk.h has them.
inline cpVect operator*(const cpVect v, const cpFloat s) {
  return {v.x * s, v.y * s};
}
inline cpVect operator+(const cpVect v1, const cpVect v2) {
  return {v1.x + v2.x, v1.y + v2.y};
}
inline cpVect operator-(const cpVect v1, const cpVect v2) {
  return {v1.x - v2.x, v1.y - v2.y};
}
inline cpVect operator-(const cpVect v) {
  return {-v.x, -v.y};
}
// The one that is missing, as the pages of the headers print it.
inline cpVect operator*(cpFloat s, cpVect v) {
  return v * s;
}

struct chipmunk {
  using Vec = cpVect;
  using Real = cpFloat;
  using Time = double;
  static constexpr int size = 2;
  static constexpr const char* name = "Chipmunk’s cpVect";
  static Vec make(const Real* from) { return {from[0], from[1]}; }
  static Real read(const Vec& x, int i) { return i == 0 ? x.x : i == 1 ? x.y : 0; }
};

}  // namespace kinds
