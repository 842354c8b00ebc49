// SPDX-License-Identifier: MIT-0
// What the tests of orientation.h have in common: bodies, and the truth in long double.
#pragma once
#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "measure/tumbling.h"
#include "scenes/euler_top.h"
#include "shelf/orientation.h"

using measure::by_bullet;
using measure::by_midpoint;
using measure::by_rotations;
using scenes::EulerTop;

using Long = EulerTop::Real;
using V = EulerTop::Vec;
using M = EulerTop::Matrix;

template <class Real>
inline constexpr Long rounding = std::numeric_limits<Real>::epsilon();

template <class Real>
shelf::Vec3<Real> vec(const V& v) {
  return {Real(v.x()), Real(v.y()), Real(v.z())};
}

template <class Real>
V exact(const shelf::Vec3<Real>& v) {
  return V(v.x, v.y, v.z);
}

template <class Real>
Eigen::Quaternion<Long> exact(const shelf::Quaternion<Real>& q) {
  return {q.w, q.x, q.y, q.z};
}

template <class Real>
M matrix(const shelf::Quaternion<Real>& q) {
  return exact(q).normalized().toRotationMatrix();
}

inline M about(const V& w, Long h) {
  return Eigen::AngleAxis<Long>(w.norm() * h, w.normalized()).toRotationMatrix();
}

template <class Real>
Long length(const shelf::Quaternion<Real>& q) {
  return exact(q).norm();
}

inline std::mt19937 engine(14);

inline Long number(Long from, Long to) {
  return std::uniform_real_distribution<double>(double(from), double(to))(engine);
}

inline V direction() {
  return V(number(-1, 1), number(-1, 1), number(-1, 1)).normalized();
}

template <class Real>
shelf::Quaternion<Real> some_orientation() {
  const Eigen::Quaternion<Long> q(Eigen::AngleAxis<Long>(number(0, 3), direction()));
  return {Real(q.w()), Real(q.x()), Real(q.y()), Real(q.z())};
}

// The book: thrown about its middle axis, and a little beside it.
inline const V thrown_inertia(1, 2, 3), thrown_w(0.2L, 20, 0.2L);

template <class Real>
struct Body {
  shelf::Vec3<Real> inertia, L;
  shelf::Quaternion<Real> q;

  explicit Body(const V& moments = thrown_inertia, const V& w = thrown_w)
      : inertia(vec<Real>(moments)), L(vec<Real>(moments.cwiseProduct(w))) {}

  // As its orientation has it, in the body's axes.
  V momentum() const { return matrix(q).transpose() * exact(L); }
  V spin() const { return momentum().cwiseQuotient(exact(inertia)); }
  Long energy() const { return momentum().dot(spin()) / 2; }
};

// How far roundings of an orientation may take a body in a step: a momentum that is one rounding
// off, about an axis with a small moment, is a spin that is many off.
template <class Real>
Long roundings(const V& inertia, const V& L, Long h) {
  return 4 * rounding<Real> * (1 + L.norm() * std::abs(h) / inertia.minCoeff());
}

// The kinds of bodies: with two equal moments or none, thick, flat, and long.
inline std::vector<V> bodies() {
  return {V(1, 2, 3), V(3, 1, 2),     V(2, 3, 1),     V(1, 1, 2),           V(2, 1, 2),
          V(1, 2, 2), V(1, 1, 1e-3L), V(1e-3L, 1, 1), V(1, 1.0001L, 2e-4L), V(0.02L, 0.03L, 0.04L)};
}
