// SPDX-License-Identifier: MIT-0
/// @file
/// Steps whose growth is known.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "format_values.h"
#include "judge/random.h"

namespace hidden {

using Polynomial = std::array<double, 5>;

struct Matrix {
  double xx, xv, vx, vv;
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

/// Steps that leave place or velocity to itself, lose both at once, hang at zero, or grow and
/// shrink by next to nothing; and their growth.
inline std::vector<std::pair<Step, double>> simple() {
  std::vector<std::pair<Step, double>> steps;
  const auto add = [&](const Matrix& m, double growth) {
    for (const double rest : {0.0, 0.75}) {
      Step step{{{{m.xx}, {m.xv}, {m.vx}, {m.vv}}}};
      step.x_rest = rest;
      step.v_rest = -2 * rest;
      steps.emplace_back(step, growth);
    }
  };
  add({0.5, 0, 0, -1.25}, 1.25);
  add({1.5, 0, 0, 0.5}, 1.5);
  add({0, 0.5, 0, 0.5}, 0.5);
  add({0.25, 0, 2, 0.75}, 0.75);
  add({0, 2, -2, 0}, 2);
  add({0, 0.5, 2, 0}, 1);
  add({1.0 / 1024, 0, 0, 0.5}, 0.5);
  add({1 + 0x1p-11, 0, 0, 1 - 0x1p-11}, 1 + 0x1p-11);
  return steps;
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

/// The methods on a spring of frequency w and drag c per second, zeta below one.
inline std::vector<Method> methods(double w, double zeta) {
  const double k = w * w, c = 2 * zeta * w, root = std::sqrt(1 + zeta * zeta);
  return {
      {"Euler's method", {{{{1}, {0, 1}, {0, -k}, {1, -c}}}}, 2 * zeta / w},
      {"symplectic Euler", {{{{1, 0, -k}, {0, 1, -c}, {0, -k}, {1, -c}}}}, 2 * (root - zeta) / w},
      {"symplectic Euler with drag divided",
       {{{{1, c, -k}, {0, 1}, {0, -k}, {1}}}, {1, c, 0}},
       2 * (root + zeta) / w},
      {"backward Euler", {{{{1, c}, {0, 1}, {0, -k}, {1}}}, {1, c, k}}, INFINITY},
      // It grows as much as a stable step may.
      {"a turn that grows by a ten-billionth", {{{{0}, {1 + 1e-10}, {-1 - 1e-10}, {0}}}}, INFINITY},
  };
}

/// Diagnoses of a longest stable step that is none.
inline std::vector<std::string> what_is_wrong(double got, double expected, double most) {
  if (!(got > 1e-6 * expected)) return {"no step was found stable: is the growth right?"};
  if (std::abs(got / expected - 1) < 0.01)
    return {"near, and not to a millionth: did the search end too early?"};
  if (got > most) return {"this is longer than `most`, beyond which no step was asked for"};
  return {got > expected ? "at your step this explodes" : "longer steps are stable, too"};
}

}  // namespace hidden
