// SPDX-License-Identifier: MIT-0
// Unreal Engine 5: FVector, of doubles, with its operators as members but for the scalar on the
// left.
#pragma once
#include <type_traits>

namespace kinds {

struct FVector {
  double X, Y, Z;

  FVector() {}
  explicit FVector(double all) : X(all), Y(all), Z(all) {}
  FVector(double x, double y, double z) : X(x), Y(y), Z(z) {}
  FVector operator+(const FVector& q) const { return {X + q.X, Y + q.Y, Z + q.Z}; }
  FVector operator-(const FVector& q) const { return {X - q.X, Y - q.Y, Z - q.Z}; }
  FVector operator*(const FVector& q) const { return {X * q.X, Y * q.Y, Z * q.Z}; }
  template <class Number, std::enable_if_t<std::is_arithmetic_v<Number>, int> = 0>
  FVector operator*(Number s) const {
    return {X * s, Y * s, Z * s};
  }
};
template <class Number, std::enable_if_t<std::is_arithmetic_v<Number>, int> = 0>
FVector operator*(Number s, const FVector& p) {
  return p * s;
}

struct unreal {
  using Vec = FVector;
  using Real = double;
  using Time = double;
  static constexpr int size = 3;
  static constexpr const char* name = "Unreal’s FVector";
  static Vec make(const Real* from) { return {from[0], from[1], from[2]}; }
  static Real read(const Vec& x, int i) { return i == 0 ? x.X : i == 1 ? x.Y : x.Z; }
};

}  // namespace kinds
