// SPDX-License-Identifier: MIT-0
/// @file
/// The reader's scene as an OwnForce. Included behind a header that defines `Vec`; the function
/// `Vec acceleration(const Vec& x, const Vec& v, double t)`; and `start_x` and `start_v`.
#pragma once
#include <concepts>
#include <stdexcept>

#include "choose/own_force.h"
#include "choose/own_vec.h"

namespace own {

/// Vectors for which the reader has written an acceleration.
template <class T>
concept IsAccelerated = requires(const T& x) {
  { acceleration(x, x, 0.0) } -> std::convertible_to<T>;
};

static_assert(HasNumbers<Vec>,
              "Vec has to be double, float, a vector of Eigen's, or a type that holds doubles or "
              "floats alone");
static_assert(Moves<Vec>,
              "Vec needs + and *, as in x + h * v, with the number in front, of the type that Vec "
              "holds");
static_assert(IsAccelerated<Vec>,
              "it needs a function acceleration that can be called with (Vec x, Vec v, double t) "
              "and returns a Vec");
static_assert(std::constructible_from<Vec, decltype(start_x)> &&
                  std::constructible_from<Vec, decltype(start_v)>,
              "start_x and start_v have to be of the type Vec");

/// A vector with these numbers.
inline Vec vec(const double* numbers) {
  Vec x(start_x);
  for (int i = 0; i < numbers_in(x); ++i) numbers_of(x)[i] = Real<Vec>(numbers[i]);
  return x;
}

/// Writes the numbers of a vector.
inline void write(Vec x, double* numbers) {
  for (int i = 0; i < numbers_in(x); ++i) numbers[i] = double(numbers_of(x)[i]);
}

/// The reader's scene.
inline OwnForce force() {
  return {numbers_in(Vec(start_x)), std::same_as<Real<Vec>, float>,
          [](double* x, double* v) {
            if (!adds_up(Vec(start_x), Vec(start_v))) {
              throw std::invalid_argument(
                  "start_x + start_v is not the sum of their numbers; Vec has to hold doubles or "
                  "floats alone, and both have to hold as many");
            }
            write(Vec(start_x), x);
            write(Vec(start_v), v);
          },
          [](const double* x, const double* v, double t, double* a) {
            write(Vec(acceleration(vec(x), vec(v), t)), a);
          }};
}

}  // namespace own
