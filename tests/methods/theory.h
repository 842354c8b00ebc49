// SPDX-License-Identifier: MIT-0
// What paper says of each method on x'' = -omega^2 x - c x': the characteristic polynomial of one
// step. Nothing in here calls a method.
#pragma once
#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <complex>
#include <concepts>

#include "measure/list.h"

namespace theory {

using Complex = std::complex<double>;

template <class Method, class... Methods>
concept OneOf = (std::same_as<Method, Methods> || ...);

// A linear force as one step sees it: s is (h omega)^2, d is c h.
struct Force {
  double s, d;
};

inline Force drag(double ch) {
  return {0, ch};
}
inline Force spring(double h_omega, double zeta) {
  return {h_omega * h_omega, 2 * zeta * h_omega};
}

// A method for z' = f(z) multiplies every solution exp(lambda t) by a function of z = h lambda.
template <int Degree>
Complex taylor(Complex z) {
  Complex sum = 1;
  for (int n = Degree; n >= 1; --n) sum = 1.0 + z / double(n) * sum;
  return sum;
}
template <int Degree>
Complex geometric(Complex z) {
  Complex sum = 1;
  for (int n = Degree; n >= 1; --n) sum = 1.0 + z * sum;
  return sum;
}
inline Complex factor(list::Euler, Complex z) {
  return taylor<1>(z);
}
inline Complex factor(OneOf<list::Midpoint, list::Heun> auto, Complex z) {
  return taylor<2>(z);
}
inline Complex factor(OneOf<list::Rk4, list::Rk4Linear> auto, Complex z) {
  return taylor<4>(z);
}
inline Complex factor(list::Dopri5, Complex z) {
  return taylor<5>(z) + std::pow(z, 6) / 600.0;
}
inline Complex factor(list::PredictedEuler, Complex z) {
  return geometric<2>(z);
}
inline Complex factor(
    OneOf<list::BackwardEuler, list::BackwardEulerNewton, list::BackwardEulerSpring> auto,
    Complex z) {
  return 1.0 / (1.0 - z);
}
inline Complex factor(OneOf<list::Trapezoid, list::TrapezoidNewton> auto, Complex z) {
  return (1.0 + z / 2.0) / (1.0 - z / 2.0);
}
inline Complex factor(list::SpringExact, Complex z) {
  return std::exp(z);
}

// lambda^3 + p[0] lambda^2 + p[1] lambda + p[2]; a matrix of two rows has a root of zero as well.
using Polynomial = std::array<double, 3>;

inline Polynomial characteristic(const Eigen::MatrixXd& m) {
  if (m.rows() == 2) return {-m.trace(), m.determinant(), 0};
  return {-m.trace(), (m.trace() * m.trace() - (m * m).trace()) / 2, -m.determinant()};
}

// From the two rates z of the force, where z^2 + d z + s = 0.
template <class Method>
  requires requires { factor(Method(), Complex()); }
Polynomial characteristic(Method method, Force f) {
  const Complex root = std::sqrt(Complex(f.d * f.d / 4 - f.s));
  const Complex first = factor(method, -f.d / 2 + root), second = factor(method, -f.d / 2 - root);
  return {-(first + second).real(), (first * second).real(), 0};
}

inline Polynomial characteristic(list::ConstantAcceleration, Force f) {
  return {f.d + f.s / 2 - 2, 1 - f.d + f.s / 2, 0};
}

// x_next - 2 x + x_previous = -s x - d (x - x_previous), in one guise or another.
inline Polynomial characteristic(
    OneOf<list::SymplecticEuler, list::SymplecticEulerPositionFirst, list::StormerVerlet,
          list::StormerVerletUneven, list::Leapfrog> auto,
    Force f) {
  return {f.s + f.d - 2, 1 - f.d, 0};
}

// The same, but drag sees x - x_previous + a_previous / 2.
inline Polynomial characteristic(OneOf<list::StormerVerletCarried, list::VelocityVerlet> auto,
                                 Force f) {
  return {f.s + 1.5 * f.d - 2, 1 - 2 * f.d, f.d / 2};
}

// Velocity Verlet for a part of a step, on x, h v and h^2 a.
inline Eigen::Matrix3d verlet(double part, Force f) {
  const Eigen::RowVector3d x{1, part, part * part / 2}, predicted{0, 1, part};
  const Eigen::RowVector3d a = -f.s * x - f.d * predicted;
  Eigen::Matrix3d step;
  step << x, Eigen::RowVector3d(0, 1, part / 2) + part / 2 * a, a;
  return step;
}
inline Eigen::Matrix3d yoshida4(Force f) {
  const double outer = 1 / (2 - std::cbrt(2.0));
  return verlet(outer, f) * verlet(1 - 2 * outer, f) * verlet(outer, f);
}
inline Polynomial characteristic(list::Yoshida4, Force f) {
  return characteristic(yoshida4(f));
}

}  // namespace theory
