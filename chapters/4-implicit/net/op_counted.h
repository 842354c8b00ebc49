// SPDX-License-Identifier: MIT-0
/// @file
/// A number that counts what is done with it.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <numbers>

/// A double that counts multiplications, divisions and square roots.
struct Tallied {
  double value = 0;
  inline static long operations = 0;  ///< how many there were

  constexpr Tallied() = default;
  constexpr Tallied(double number) : value(number) {}
  explicit operator double() const { return value; }

  Tallied& operator+=(Tallied b) { return *this = *this + b; }
  Tallied& operator-=(Tallied b) { return *this = *this - b; }
  Tallied& operator*=(Tallied b) { return *this = *this * b; }
  Tallied& operator/=(Tallied b) { return *this = *this / b; }

  friend constexpr Tallied operator-(Tallied a) { return -a.value; }
  friend constexpr Tallied operator+(Tallied a, Tallied b) { return a.value + b.value; }
  friend constexpr Tallied operator-(Tallied a, Tallied b) { return a.value - b.value; }
  friend Tallied operator*(Tallied a, Tallied b) { return ++operations, a.value * b.value; }
  friend Tallied operator/(Tallied a, Tallied b) { return ++operations, a.value / b.value; }
  friend Tallied sqrt(Tallied a) { return ++operations, std::sqrt(a.value); }
  friend Tallied abs(Tallied a) { return std::abs(a.value); }
  friend constexpr auto operator<=>(Tallied a, Tallied b) { return a.value <=> b.value; }
  friend constexpr bool operator==(Tallied a, Tallied b) { return a.value == b.value; }
};

template <>
inline constexpr Tallied std::numbers::sqrt2_v<Tallied> = std::numbers::sqrt2;

template <>
struct Eigen::NumTraits<Tallied> : Eigen::NumTraits<double> {
  using Real = Tallied;
  using NonInteger = Tallied;
  using Nested = Tallied;
  using Literal = Tallied;
};
