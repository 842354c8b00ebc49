// SPDX-License-Identifier: MIT-0
// A vector of three numbers that can do no more than the shelf may ask for.
#pragma once
#include <cmath>

template <class Real>
struct Three {
  Real x, y, z;

  friend constexpr Three operator+(Three p, Three q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
  friend constexpr Three operator*(Real s, Three p) { return {s * p.x, s * p.y, s * p.z}; }
  friend constexpr bool operator==(Three p, Three q) = default;
};

inline constexpr auto dot = [](const auto& p, const auto& q) {
  return p.x * q.x + p.y * q.y + p.z * q.z;
};

inline constexpr auto norm = [](const auto& p) { return std::sqrt(dot(p, p)); };

using Long = Three<long double>;

template <class Real>
Long exactly(const Three<Real>& p) {
  return {p.x, p.y, p.z};
}

inline long double apart(const Long& p, const Long& q) {
  return norm(p + -1.0L * q);
}
