// SPDX-License-Identifier: MIT-0
/// @file
/// What a step that a reader writes in the page is compiled with: vectors, the functions of <cmath>
/// that steps need, and the scene's acceleration. No header of a library: each costs seconds.
#pragma once

#define EXPORT(name) extern "C" __attribute__((export_name(#name), no_sanitize("coverage")))

using Real = double;
using Time = double;
using Clock = double;

/// What a place and a velocity are made of; those dimensions that a scene has not are zero.
struct Vec {
  double x = 0, y = 0, z = 0;
};
using Position = Vec;

constexpr Vec operator+(Vec a, Vec b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vec operator-(Vec a, Vec b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vec operator-(Vec a) {
  return {-a.x, -a.y, -a.z};
}
constexpr Vec operator*(double s, Vec a) {
  return {s * a.x, s * a.y, s * a.z};
}
constexpr Vec operator*(Vec a, double s) {
  return s * a;
}
constexpr Vec operator/(Vec a, double s) {
  return {a.x / s, a.y / s, a.z / s};
}
constexpr Vec& operator+=(Vec& a, Vec b) {
  return a = a + b;
}
constexpr Vec& operator-=(Vec& a, Vec b) {
  return a = a - b;
}
constexpr Vec& operator*=(Vec& a, double s) {
  return a = s * a;
}
constexpr double dot(Vec a, Vec b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

extern "C" {
double sin(double), cos(double), tan(double), asin(double), acos(double), atan(double);
double atan2(double, double), exp(double), log(double), pow(double, double), sqrt(double);
}
inline double abs(double x) {
  return __builtin_fabs(x);
}
constexpr double min(double a, double b) {
  return b < a ? b : a;
}
constexpr double max(double a, double b) {
  return a < b ? b : a;
}
namespace std {
using ::abs, ::acos, ::asin, ::atan, ::atan2, ::cos, ::exp, ::log, ::max, ::min, ::pow, ::sin,
    ::sqrt, ::tan;
}

inline double length(Vec a) {
  return sqrt(dot(a, a));
}

/// What the page joins to the scene: place, velocity and time in, acceleration out.
extern "C" __attribute__((import_module("scene"), import_name("acceleration"))) void ask(
    double* at);

struct Acceleration {
  Vec operator()(Vec x, Vec v, double t) const {
    double at[7] = {x.x, x.y, x.z, v.x, v.y, v.z, t};
    ask(at);
    return {at[0], at[1], at[2]};
  }
};

/// A step that goes on for ever is stopped: the compiler calls this on each way through it.
inline long fuel = 0;
extern "C" __attribute__((used, no_sanitize("coverage"))) void __sanitizer_cov_trace_pc() {
  if (--fuel < 0) __builtin_trap();
}
