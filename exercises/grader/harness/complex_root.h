// SPDX-License-Identifier: MIT-0
/// @file
/// The root of a complex number, as exact as the C library's. That of libc++ goes by the angle, and
/// gives the root of -1 a real part.
#ifndef COMPLEX_ROOT_H
#define COMPLEX_ROOT_H
#include <complex>

#ifdef _LIBCPP_VERSION
template <>
inline std::complex<double> std::sqrt(const std::complex<double>& number) {
  const auto root = __builtin_csqrt(__builtin_complex(number.real(), number.imag()));
  return {__real__ root, __imag__ root};
}
#endif
#endif
