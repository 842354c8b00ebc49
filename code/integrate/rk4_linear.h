// SPDX-License-Identifier: MIT-0
/// @file
/// Runge-Kutta 4 on a known linear force, folded into one matrix.
///
/// @code
/// double x = 1, v = 0;
/// const auto step = integrate::rk4_linear_start(9.0, 1.0, 1 / 60.0);  // x'' = -9 x - x'
/// for (int n = 0; n < 60; ++n) integrate::rk4_linear(x, v, step);
/// @endcode
#pragma once
#include <type_traits>

namespace integrate {

/// One step of RK4 on a linear force as a matrix: x becomes xx*x + xv*v, v becomes vx*x + vv*v.
/// @see rk4_linear_start
template <class Real>
struct Rk4Linear {
  Real xx;  ///< part of the old position in the new position
  Real xv;  ///< part of the old velocity in the new position [s]
  Real vx;  ///< part of the old position in the new velocity [1/s]
  Real vv;  ///< part of the old velocity in the new velocity
};

/// The matrix of one RK4 step of x'' = -k x - c x', worked out once for all steps of this length.
///
/// With Z the matrix of the equation times h, it is 1 + Z + Z^2/2 + Z^3/6 + Z^4/24.
///
/// @param k  stiffness per mass [1/s^2]; omega^2 of a spring
/// @param c  damping per mass [1/s]; 2 zeta omega of a spring
/// @param h  step size [s]; a negative step goes back in time
template <class Real>
constexpr Rk4Linear<Real> rk4_linear_start(Real k, Real c, Real h) {
  static_assert(!std::is_integral_v<Real>, "k, c and h must not be integers");
  Rk4Linear<Real> sum{Real(1), Real(0), Real(0), Real(1)};
  for (int n = 4; n >= 1; --n) {  // Horner: 1 + Z (1 + Z/2 (1 + Z/3 (1 + Z/4)))
    const Real part = h / Real(n);
    sum = {Real(1) + part * sum.vx, part * sum.vv, part * (-k * sum.xx - c * sum.vx),
           Real(1) + part * (-k * sum.xv - c * sum.vv)};
  }
  return sum;
}

/// One step of RK4 on a linear force, by its matrix.
///
/// Order 4, no evaluation of the acceleration, stable on drag while c*h < 2.785, on an undamped
/// spring while h*omega < 2.828. The same trajectory as rk4.h gives, up to rounding.
///
/// @param x  position from where the force is zero, advanced in place
/// @param v  velocity, advanced in place
/// @param step  the matrix, from rk4_linear_start
/// @see W. Kutta, Beitrag zur naeherungsweisen Integration totaler Differentialgleichungen (1901)
template <class Vec, class Real>
constexpr void rk4_linear(Vec& x, Vec& v, const Rk4Linear<Real>& step) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(scales, "the matrix times x must be a Vec: make it with the number type of Vec");
  if constexpr (scales) {
    // [move]
    const Vec x_start = x;
    x = step.xx * x_start + step.xv * v;
    v = step.vx * x_start + step.vv * v;
    // [move]
  }
}

}  // namespace integrate
