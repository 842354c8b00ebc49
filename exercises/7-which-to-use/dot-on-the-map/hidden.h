// SPDX-License-Identifier: MIT-0
/// @file
/// Steps whose growth is known.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "format_values.h"
#include "judge/random.h"

namespace hidden {

using Polynomial = std::array<double, 5>;

struct Matrix {
  double xx, xv, vx, vv;

  double trace() const { return xx + vv; }
  double determinant() const { return xx * vv - xv * vx; }

  /// Whether this solves the equation of the eigenvalues, or is the size of two that are not real.
  bool has_growth(double size) const {
    const auto solves = [&](double value) {
      return std::abs((value - trace()) * value + determinant()) < 1e-9 * (1 + size * size);
    };
    const bool swings = trace() * trace() < 4 * determinant();
    return swings ? std::abs(size * size - determinant()) < 1e-9 * (1 + size * size)
                  : solves(size) || solves(-size);
  }

  /// What comes of the columns if nobody takes away what the step makes of (0, 0).
  Matrix beside(double x0, double v0) const { return {xx + x0, xv + x0, vx + v0, vv + v0}; }

  double largest_row() const {
    return std::max(std::abs(xx) + std::abs(xv), std::abs(vx) + std::abs(vv));
  }
};

/// A step as the harness reads it: its matrix is `above` over `below`, in powers of h.
struct Step {
  std::array<Polynomial, 4> above;  ///< xx, xv, vx, vv
  std::array<double, 3> below{1, 0, 0};
  double x_rest = 0, v_rest = 0;

  std::vector<double> arguments(double h) const {
    std::vector<double> numbers;
    for (const Polynomial& entry : above) numbers.insert(numbers.end(), entry.begin(), entry.end());
    numbers.insert(numbers.end(), below.begin(), below.end());
    numbers.insert(numbers.end(), {x_rest, v_rest, h});
    return numbers;
  }

  Matrix matrix(double h) const {
    const auto at = [=](const auto& polynomial) {
      double sum = 0;
      for (std::size_t n = polynomial.size(); n-- > 0;) sum = sum * h + polynomial[n];
      return sum;
    };
    const double under = at(below);
    return {at(above[0]) / under, at(above[1]) / under, at(above[2]) / under, at(above[3]) / under};
  }
};

/// A matrix with these eigenvalues, or with the pair `a` plus and minus `b` times i, as it looks
/// from starts that are not its own.
inline Step with_eigenvalues(judge::Random& random, double a, double b, bool swings) {
  const double xx = a, xv = swings ? -b : 0, vx = swings ? b : 0, vv = swings ? a : b;
  const double p = random.between(0.5, 1.5), q = random.between(-1, 1), r = random.between(-1, 1);
  const double s = (1 + q * r) / p;  // determinant 1
  const double ax = p * xx + q * vx, av = p * xv + q * vv;
  const double bx = r * xx + s * vx, bv = r * xv + s * vv;
  Step step{{{{ax * s - av * r}, {av * p - ax * q}, {bx * s - bv * r}, {bv * p - bx * q}}}};
  step.x_rest = random.between(-2, 2);
  step.v_rest = random.between(-0.5, 0.5);
  return step;
}

inline std::string described(const Step& step) {
  const auto entry = [&](std::size_t n) { return grade::number(step.above[n][0], 17); };
  return "the matrix (" + entry(0) + ", " + entry(1) + "; " + entry(2) + ", " + entry(3) +
         ") about x = " + grade::number(step.x_rest, 17) +
         ", v = " + grade::number(step.v_rest, 17);
}

/// A method on a damped spring, and the longest step that it bears.
struct Method {
  std::string name;
  Step step;
  double limit;  ///< [s]
};

/// Of frequency w and drag c per second, zeta below one.
inline std::vector<Method> methods(double w, double zeta) {
  const double k = w * w, c = 2 * zeta * w, root = std::sqrt(1 + zeta * zeta);
  return {
      {"Euler's method", {{{{1}, {0, 1}, {0, -k}, {1, -c}}}}, 2 * zeta / w},
      {"symplectic Euler", {{{{1, 0, -k}, {0, 1, -c}, {0, -k}, {1, -c}}}}, 2 * (root - zeta) / w},
      {"symplectic Euler with drag divided",
       {{{{1, c, -k}, {0, 1}, {0, -k}, {1}}}, {1, c, 0}},
       2 * (root + zeta) / w},
      {"backward Euler", {{{{1, c}, {0, 1}, {0, -k}, {1}}}, {1, c, k}}, INFINITY},
  };
}

using Says = std::vector<std::string>;

inline bool alike(double a, double b) {
  return std::abs(a - b) <= 1e-9 * (1 + std::abs(b));
}

/// What may have been taken for the growth.
inline Says recognise_growth(double got, const Step& step, double expected) {
  const Matrix matrix = step.matrix(0);
  const double x0 = step.x_rest - matrix.xx * step.x_rest - matrix.xv * step.v_rest;
  const double v0 = step.v_rest - matrix.vx * step.x_rest - matrix.vv * step.v_rest;
  const bool swings = matrix.trace() * matrix.trace() < 4 * matrix.determinant();
  if (swings && alike(got, std::abs(matrix.trace()) / 2))
    return {"this is the real part of the two eigenvalues; they are not real, and larger"};
  if (!swings && alike(got, std::sqrt(std::abs(matrix.determinant()))))
    return {"this is the root of the product of the two eigenvalues, as if both were of one size"};
  if (!swings && matrix.has_growth(got))
    return {"this is the one of the two eigenvalues that is nearer to zero"};
  if (matrix.beside(x0, v0).has_growth(got))
    return {"the columns still hold what the step makes of (0, 0)"};
  if (alike(got, matrix.largest_row()))
    return {"this is how far one step can carry a start, and not what many steps do"};
  if (std::abs(got / expected - 1) < 2e-6)
    return {"right to six digits and no further: a float, or a search that ends early?"};
  if (std::abs(got / expected - 1) < 0.01)
    return {"near, and not exact: is it measured in a run? Where that began still counts in it"};
  return {};
}

/// What may have been taken for the longest stable step.
inline Says recognise_longest(double got, const Method& method, double w, double expected,
                              double most) {
  if (alike(got, 2 / w) && !alike(got, expected))
    return {
        "this is 2/omega, the limit of symplectic Euler without damping, and not this method's"};
  if (!(got > 1e-6 * expected)) return {"no step was found stable: is the growth right?"};
  if (std::abs(got / expected - 1) < 0.01)
    return {"near, and not to a millionth: did the search end too early?"};
  if (method.step.matrix(got).has_growth(2))
    return {"at your step the growth is 2; it may be 1 + 1e-9 at most"};
  if (got > most) return {"this is longer than `most`, beyond which no step was asked for"};
  if (got > expected) return {"at your step this explodes"};
  return {"longer steps are stable, too"};
}

}  // namespace hidden
