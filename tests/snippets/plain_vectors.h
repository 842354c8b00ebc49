// SPDX-License-Identifier: MIT-0
// The vectors that need no library.
#pragma once
#include "same_steps.h"

// The least that a method may ask of a vector.
struct Plain {
  float a, b;
};
inline Plain operator+(Plain p, Plain q) {
  return {p.a + q.a, p.b + q.b};
}
inline Plain operator*(float s, Plain p) {
  return {s * p.a, s * p.b};
}

struct Plains {
  using Vec = Plain;
  using Real = float;
  using Time = double;
  static constexpr int size = 2;
  static constexpr const char* name = "a plain struct";
  static Vec make(const Real* from) { return {from[0], from[1]}; }
  static Real read(const Vec& x, int i) { return i == 0 ? x.a : x.b; }
};

struct Attempt {
  int wrong = 0;

  template <class Method>
  void operator()(const char* name, Method method) {
    wrong += numbers_wrong(name, method) + differences<Plains>(name, method);
  }
};
