// SPDX-License-Identifier: MIT-0
/// @file
/// What every exercise is given: a vector, and the force of the scene.
#ifndef GIVEN_H
#define GIVEN_H
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

/// A vector of three numbers, such as a position [m] or a velocity [m/s].
struct Vec {
  double x = 0, y = 0, z = 0;
};

constexpr Vec operator+(const Vec& a, const Vec& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vec operator-(const Vec& a, const Vec& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vec operator-(const Vec& a) {
  return {-a.x, -a.y, -a.z};
}
constexpr Vec operator*(double s, const Vec& a) {
  return {s * a.x, s * a.y, s * a.z};
}
constexpr Vec operator*(const Vec& a, double s) {
  return s * a;
}
constexpr Vec operator/(const Vec& a, double s) {
  return {a.x / s, a.y / s, a.z / s};
}
constexpr Vec& operator+=(Vec& a, const Vec& b) {
  return a = a + b;
}
constexpr Vec& operator-=(Vec& a, const Vec& b) {
  return a = a - b;
}
constexpr Vec& operator*=(Vec& a, double s) {
  return a = s * a;
}
constexpr Vec& operator/=(Vec& a, double s) {
  return a = a / s;
}

constexpr double dot(const Vec& a, const Vec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline double length(const Vec& a) {
  return std::sqrt(dot(a, a));
}

/// The acceleration of the scene [m/s^2] at a position [m], with a velocity [m/s], at a time [s].
/// Each call is counted.
using Acceleration = std::function<Vec(const Vec& x, const Vec& v, double t)>;

#ifdef GRADING
#include "steps.h"
#endif
#endif
