// SPDX-License-Identifier: MIT-0
// ODE: dVector3 is an array, which nothing can return, so its users copy it into a struct of
// theirs.
#pragma once

namespace kinds {

using dReal = double;
using dVector3 = dReal[4];  // the fourth is there for alignment alone

// Made of what dBodyGetPosition hands out; dBodySetPosition takes its three numbers back.
struct OdeVector {
  dReal x, y, z;

  explicit OdeVector(const dReal* from) : OdeVector(from[0], from[1], from[2]) {}
  OdeVector(dReal px, dReal py, dReal pz) : x(px), y(py), z(pz) {}
};
inline OdeVector operator+(const OdeVector& p, const OdeVector& q) {
  return {p.x + q.x, p.y + q.y, p.z + q.z};
}
inline OdeVector operator*(dReal s, const OdeVector& p) {
  return {s * p.x, s * p.y, s * p.z};
}

struct ode {
  using Vec = OdeVector;
  using Real = dReal;
  using Time = double;
  static constexpr int size = 3;
  static constexpr const char* name = "a copy of ODE’s dVector3";
  static Vec make(const Real* from) {
    const dVector3 place = {from[0], from[1], from[2], 0};
    return OdeVector(place);
  }
  static Real read(const Vec& x, int i) { return i == 0 ? x.x : i == 1 ? x.y : x.z; }
};

}  // namespace kinds
