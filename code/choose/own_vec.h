// SPDX-License-Identifier: MIT-0
/// @file
/// The numbers of a reader's own vector: of a double or a float, of Eigen's, or of any type that
/// holds doubles or floats alone, such as a glm::vec3.
#pragma once
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

/// What a reader's scene has to be, and how its numbers are got at.
namespace own {

/// Vectors of Eigen's, which say how many numbers they hold.
template <class Vec>
concept IsEigen = requires(Vec& x) {
  typename Vec::Scalar;
  x.data();
  x.size();
};

/// Vectors of which nothing but the numbers is stored, in their place.
template <class Vec>
concept IsPlain = std::is_standard_layout_v<Vec> && !requires(Vec& x) { x.size(); };

/// What is found behind x[0], in x.x, or else what has to be aligned like this.
template <class Vec>
auto first_number() {
  if constexpr (std::is_arithmetic_v<Vec>) {
    return Vec();
  } else if constexpr (IsEigen<Vec>) {
    return typename Vec::Scalar();
  } else if constexpr (requires(const Vec& x) { x[0]; }) {
    return std::decay_t<decltype(std::declval<const Vec&>()[0])>();
  } else if constexpr (requires(const Vec& x) { std::decay_t<decltype(x.x)>(x.x); }) {
    return std::decay_t<decltype(std::declval<const Vec&>().x)>();
  } else {
    return std::conditional_t<alignof(Vec) == alignof(double), double, float>();
  }
}

/// The type of a vector's numbers.
template <class Vec>
using Real = decltype(first_number<Vec>());

/// Vectors whose numbers can be read and written.
template <class Vec>
concept HasNumbers = (std::same_as<Real<Vec>, double> || std::same_as<Real<Vec>, float>) &&
                     (IsEigen<Vec> || IsPlain<Vec>);

/// Vectors that a method can move.
template <class Vec>
concept Moves = requires(const Vec& x, Real<Vec> h) {
  { x + x } -> std::convertible_to<Vec>;
  { h* x } -> std::convertible_to<Vec>;
};

/// The numbers of a vector.
template <class Vec>
Real<Vec>* numbers_of(Vec& x) {
  if constexpr (IsEigen<Vec>) {
    return x.data();
  } else {
    return reinterpret_cast<Real<Vec>*>(&x);
  }
}

/// How many numbers a vector has.
template <class Vec>
int numbers_in(const Vec& x) {
  if constexpr (IsEigen<Vec>) {
    return int(x.size());
  } else {
    return int(sizeof(Vec) / sizeof(Real<Vec>));
  }
}

/// Whether + adds the numbers, and nothing else is among them.
template <class Vec>
bool adds_up(Vec one, Vec other) {
  Vec sum = one + other;
  for (int i = 0; i < numbers_in(sum); ++i) {
    if (numbers_of(sum)[i] != numbers_of(one)[i] + numbers_of(other)[i]) return false;
  }
  return numbers_in(one) == numbers_in(other);
}

}  // namespace own
