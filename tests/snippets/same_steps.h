// SPDX-License-Identifier: MIT-0
// Ten steps of a method on any vector, coordinate by coordinate the same as on doubles.
#pragma once
#include <cmath>
#include <cstdio>

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

// Every coordinate moves by itself, and all arguments of the acceleration matter. The clock is a
// double for all.
template <class Real, class Method, class Vec>
void take_steps(Method method, Vec& x, Vec& v, const Vec& one) {
  const auto acceleration = [&one](const Vec& at, const Vec& speed, double t) -> Vec {
    return Real(-4) * at + Real(-0.5) * speed + Real(t) * one;
  };
  for (int n = 0; n < 10; ++n) method(x, v, 0.25 + n * 0.1, Real(0.1), acceleration);
}

// One coordinate against the same steps on doubles. Returns the number of differences, 0 or 1.
template <class Method, class Real>
int differs(const char* type, Method method, Real x, Real v, double x0, double v0) {
  take_steps<double>(method, x0, v0, 1.0);
  const double tolerance = sizeof(Real) == sizeof(float) ? 1e-5 : 1e-14;
  if (std::abs(x - x0) < tolerance && std::abs(v - v0) < tolerance) return 0;
  std::printf("%s: x %.9g, v %.9g; on double: x %.9g, v %.9g\n", type, double(x), double(v), x0,
              v0);
  return 1;
}
