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

// Doubles are what all else is compared with, so they must do something; floats do the same up to
// rounding, with a clock of either type.
template <class Method>
int numbers_wrong(const char* name, Method method) {
  const auto exact = after_ten_steps<Scalar<double>>(method, {1, 2});
  const auto rounded = after_ten_steps<Scalar<float>>(method, {1, 2});
  const auto clocked = after_ten_steps<Scalar<float, float>>(method, {1, 2});
  const double tolerance = rounding<float>();
  const auto near = [&](const State<float>& s) {
    return std::abs(s.x - exact.x) < tolerance && std::abs(s.v - exact.v) < tolerance;
  };
  const bool moved = std::abs(exact.x - 1) > tolerance && std::abs(exact.v - 2) > tolerance;
  if (moved && near(rounded) && near(clocked)) return 0;
  std::printf("%s: x %.9g on double, %.9g on float, %.9g with a clock of floats, too\n", name,
              exact.x, double(rounded.x), double(clocked.x));
  std::printf("%s: v %.9g on double, %.9g on float, %.9g with a clock of floats, too\n", name,
              exact.v, double(rounded.v), double(clocked.v));
  return 1;
}

struct Attempt {
  int wrong = 0;

  template <class Method>
  void operator()(const char* name, Method method) {
    wrong += numbers_wrong(name, method) + differences<Plains>(name, method);
  }
};
