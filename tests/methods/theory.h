// SPDX-License-Identifier: MIT-0
// What paper says of each method on x'' = -omega^2 x - c x': the characteristic polynomial of one
// step. Nothing in here calls a method.
#pragma once
#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <complex>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "measure/methods.h"
#include "textbook/runge_kutta.h"

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
// In closed form where there is one.
inline Complex closed_factor(measure::Euler, Complex z) {
  return taylor<1>(z);
}
inline Complex closed_factor(OneOf<measure::Midpoint, measure::Heun> auto, Complex z) {
  return taylor<2>(z);
}
inline Complex closed_factor(OneOf<measure::Rk4, measure::Rk4Linear> auto, Complex z) {
  return taylor<4>(z);
}
inline Complex closed_factor(measure::Dopri5, Complex z) {
  return taylor<5>(z) + std::pow(z, 6) / 600.0;
}
inline Complex closed_factor(measure::PredictedEuler, Complex z) {
  return geometric<2>(z);
}
inline Complex closed_factor(
    OneOf<measure::BackwardEuler, measure::BackwardEulerNewton, measure::BackwardEulerSpring> auto,
    Complex z) {
  return 1.0 / (1.0 - z);
}
inline Complex closed_factor(OneOf<measure::Trapezoid, measure::TrapezoidNewton> auto, Complex z) {
  return (1.0 + z / 2.0) / (1.0 - z / 2.0);
}
inline Complex closed_factor(OneOf<measure::SpringExact, measure::SpringFolded> auto, Complex z) {
  return std::exp(z);
}

// Of a Runge-Kutta method it can be worked out of its table as well: each slope is z times what its
// row makes of the ones before.
template <class Method>
concept HasTable = requires(Method method) { textbook::table(method).b; };
inline Complex factor_of_table(const textbook::Table& table, Complex z) {
  std::vector<Complex> slopes;
  const auto sum = [&slopes](const textbook::Row& weights) {
    Complex total = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) total += double(weights[i]) * slopes[i];
    return total;
  };
  for (const textbook::Row& row : table.a) slopes.push_back(z * (1.0 + sum(row)));
  return 1.0 + sum(table.b);
}

template <class Method>
concept HasClosedFactor = requires(Method method) { closed_factor(method, Complex()); };
template <class Method>
concept HasFactor = HasClosedFactor<Method> || HasTable<Method>;
template <class Method>
  requires HasFactor<Method>
Complex factor(Method method, Complex z) {
  if constexpr (HasClosedFactor<Method>) {
    return closed_factor(method, z);
  } else {
    return factor_of_table(textbook::table(method), z);
  }
}

// lambda^4 + p[0] lambda^3 + p[1] lambda^2 + p[2] lambda + p[3]; a matrix of fewer rows has roots
// of zero as well.
using Polynomial = std::array<double, 4>;

inline Polynomial characteristic(const Eigen::MatrixXd& m) {
  const double trace = m.trace(), pairs = (trace * trace - (m * m).trace()) / 2;
  if (m.rows() == 2) return {-trace, m.determinant()};
  if (m.rows() == 3) return {-trace, pairs, -m.determinant()};
  const double of_squares = (m * m).trace(), of_cubes = (m * m * m).trace();
  const double triples = trace * (trace * trace - 3 * of_squares) / 6 + of_cubes / 3;
  return {-trace, pairs, -triples, m.determinant()};
}

// From the two rates z of the force, where z^2 + d z + s = 0.
template <class Method>
  requires HasFactor<Method>
Polynomial characteristic(Method method, Force f) {
  const Complex root = std::sqrt(Complex(f.d * f.d / 4 - f.s));
  const Complex first = factor(method, -f.d / 2 + root), second = factor(method, -f.d / 2 - root);
  return {-(first + second).real(), (first * second).real(), 0};
}

inline Polynomial characteristic(measure::ConstantAcceleration, Force f) {
  return {f.d + f.s / 2 - 2, 1 - f.d + f.s / 2, 0};
}

// x_next - 2 x + x_previous = -s x - d (x - x_previous), in one guise or another.
inline Polynomial characteristic(
    OneOf<measure::SymplecticEuler, measure::SymplecticEulerPositionFirst, measure::StormerVerlet,
          measure::StormerVerletDistance, measure::StormerVerletUneven, measure::Leapfrog,
          measure::LeapfrogDrift> auto,
    Force f) {
  return {f.s + f.d - 2, 1 - f.d, 0};
}

// The same, but drag sees x - x_previous + a_previous / 2.
inline Polynomial characteristic(OneOf<measure::StormerVerletCarried, measure::VelocityVerlet> auto,
                                 Force f) {
  return {f.s + 1.5 * f.d - 2, 1 - 2 * f.d, f.d / 2};
}

// Of either rate z of the force, 3/2 lambda^2 - 2 lambda + 1/2 = z lambda^2; and the product of
// both.
inline Polynomial characteristic(OneOf<measure::Bdf2, measure::Bdf2Newton> auto, Force f) {
  const Complex root = std::sqrt(Complex(f.d * f.d / 4 - f.s));
  const Complex first = 1.5 + f.d / 2 - root, second = 1.5 + f.d / 2 + root;
  const double both = (first * second).real(), sum = (first + second).real();
  return {-2 * sum / both, (4 + sum / 2) / both, -2 / both, 0.25 / both};
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
inline Polynomial characteristic(measure::Yoshida4, Force f) {
  return characteristic(yoshida4(f));
}

// The methods that are not in here are refused in one sentence, and not tested any further.
inline constexpr auto has_polynomial = [](auto method) {
  return requires { characteristic(method, Force()); };
};
using WithPolynomial = list::Where<has_polynomial>;
static_assert(std::is_same_v<WithPolynomial, list::General>,
              "tests/methods/theory.h has no polynomial of a method in code/measure/methods");

}  // namespace theory
