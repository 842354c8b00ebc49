// SPDX-License-Identifier: MIT-0
/// @file
/// A double that counts operations.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <numbers>

/// A double that counts multiplications, divisions and square roots.
struct OpCounted {
  double value = 0;
  inline static long operations = 0;  ///< how many there were

  constexpr OpCounted() = default;
  constexpr OpCounted(double number) : value(number) {}
  explicit operator double() const { return value; }

  OpCounted& operator+=(OpCounted b) { return *this = *this + b; }
  OpCounted& operator-=(OpCounted b) { return *this = *this - b; }
  OpCounted& operator*=(OpCounted b) { return *this = *this * b; }
  OpCounted& operator/=(OpCounted b) { return *this = *this / b; }

  friend constexpr OpCounted operator-(OpCounted a) { return -a.value; }
  friend constexpr OpCounted operator+(OpCounted a, OpCounted b) { return a.value + b.value; }
  friend constexpr OpCounted operator-(OpCounted a, OpCounted b) { return a.value - b.value; }
  friend OpCounted operator*(OpCounted a, OpCounted b) { return ++operations, a.value * b.value; }
  friend OpCounted operator/(OpCounted a, OpCounted b) { return ++operations, a.value / b.value; }
  friend OpCounted sqrt(OpCounted a) { return ++operations, std::sqrt(a.value); }
  friend OpCounted abs(OpCounted a) { return std::abs(a.value); }
  friend constexpr auto operator<=>(OpCounted a, OpCounted b) { return a.value <=> b.value; }
  friend constexpr bool operator==(OpCounted a, OpCounted b) { return a.value == b.value; }
};

template <>
inline constexpr OpCounted std::numbers::sqrt2_v<OpCounted> = std::numbers::sqrt2;

template <>
struct Eigen::NumTraits<OpCounted> : Eigen::NumTraits<double> {
  using Real = OpCounted;
  using NonInteger = OpCounted;
  using Nested = OpCounted;
  using Literal = OpCounted;
};
