// SPDX-License-Identifier: MIT-0
// Where games live: sixty steps a second or so, and so little in each that c h and h omega are far
// below one. There a difference of two numbers near one has few digits left, in float hardly any.
#include <Eigen/Core>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>
#include <type_traits>

#include "integrate/linear_damping.h"
#include "integrate/spring_exact.h"
#include "textbook/exponential.h"

namespace {

using textbook::Matrix;
using textbook::Real;

// A number or a vector of three, and its first coordinate; the others have other sizes.
template <class Vec>
struct Kind {
  using Number = typename Vec::Scalar;
  static Vec make(Number first) { return {first, -3 * first, first / 7}; }
  static Number read(const Vec& x) { return x[0]; }
};
template <class Vec>
  requires std::is_floating_point_v<Vec>
struct Kind<Vec> {
  using Number = Vec;
  static Vec make(Number first) { return first; }
  static Number read(Vec x) { return x; }
};

// Steps of length h, and rates with h times the rate from a millionth to one.
template <class Number, class Check>
void sweep(Check check) {
  for (const Number h : {Number(1) / 30, Number(1) / 60, Number(1) / 144, Number(1) / 1000}) {
    for (int n = 0; n <= 40; ++n) {
      const Number rate = Number(std::pow(10.0, -6 + 0.15 * n)) / h;
      CAPTURE(h, rate, h * rate);
      check(h, rate);
    }
  }
}

// Whether a number is right but for so many roundings of a number of that size.
template <class Number>
bool right(Number found, Real expected, Real size, int roundings) {
  CAPTURE(found, double(expected), double((found - expected) / size));
  const Real allowed =
      roundings * Real(std::numeric_limits<Number>::epsilon()) / 2 * std::abs(size);
  CHECK(std::abs(found - expected) <= allowed);
  return std::abs(found - expected) <= allowed;
}

// What a step keeps of the velocity, and what it makes of a push of one.
struct Damped {
  Real keep, push;
};

template <class Vec, class Step, class Theory>
void check_damping(Step step, Theory theory) {
  using Number = typename Kind<Vec>::Number;
  sweep<Number>([&](Number h, Number c) {
    const Damped expected = theory(Real(c) * h);
    const Number start = Number(-1.1), force = Number(-9.81);
    const auto run = [&](Number speed, Number pull) {
      Vec x = Kind<Vec>::make(0), v = Kind<Vec>::make(speed);
      const Vec a = Kind<Vec>::make(pull);
      step(x, v, 0.0, h, c, [&a](const Vec&, const Vec&, double) { return a; });
      right(Kind<Vec>::read(x), Real(h) * Kind<Vec>::read(v), Kind<Vec>::read(v) * h, 2);
      return Kind<Vec>::read(v);
    };
    right(run(start, 0), expected.keep * start, start, 6);
    right(run(0, force), expected.push * h * force, h * force, 6);
  });
}

}  // namespace

TEMPLATE_TEST_CASE("At the small steps of games each way to damp is right to rounding", "", float,
                   double, Eigen::Vector3f, Eigen::Vector3d) {
  const auto exponential = [](Real damping) {
    Matrix equation;
    equation << -damping, 1, 0, 0;
    return textbook::exponential(equation);
  };
  SECTION("explicit") {
    check_damping<TestType>([](auto&&... p) { integrate::linear_damping_explicit_last(p...); },
                            [](Real d) { return Damped{1 - d, 1 - d}; });
    check_damping<TestType>([](auto&&... p) { integrate::linear_damping_explicit_first(p...); },
                            [](Real d) { return Damped{1 - d, 1}; });
  }
  SECTION("implicit") {
    check_damping<TestType>([](auto&&... p) { integrate::linear_damping_implicit_last(p...); },
                            [](Real d) { return Damped{1 / (1 + d), 1 / (1 + d)}; });
    check_damping<TestType>([](auto&&... p) { integrate::linear_damping_implicit_first(p...); },
                            [](Real d) { return Damped{1 / (1 + d), 1}; });
  }
  SECTION("exponential") {
    check_damping<TestType>([](auto&&... p) { integrate::linear_damping_exponential_last(p...); },
                            [&](Real d) {
                              const Real keep = exponential(d)(0, 0);
                              return Damped{keep, keep};
                            });
    check_damping<TestType>([](auto&&... p) { integrate::linear_damping_exponential_first(p...); },
                            [&](Real d) { return Damped{exponential(d)(0, 0), 1}; });
  }
  SECTION("exact") {
    check_damping<TestType>([](auto&&... p) { integrate::linear_damping_exact(p...); },
                            [&](Real d) {
                              const Matrix all = exponential(d);
                              return Damped{all(0, 0), all(0, 1)};
                            });
  }
}

TEMPLATE_TEST_CASE("At the small steps of games the exact spring is right to rounding", "", float,
                   double, Eigen::Vector3f, Eigen::Vector3d) {
  using Number = typename Kind<TestType>::Number;
  for (const double some : {0.0, 0.1, 0.5, 0.99, 1.0, 1.01, 2.0}) {
    const Number zeta = Number(some);
    sweep<Number>([&](Number h, Number omega) {
      CAPTURE(zeta);
      // By unit of time 1/omega, so that all four entries are of the size of the step or of one.
      const Real angle = Real(h) * omega;
      Matrix equation;
      equation << 0, angle, -angle, -2 * Real(zeta) * angle;
      const Matrix expected = textbook::exponential(equation);
      const Number start = Number(0.7);
      TestType x = Kind<TestType>::make(start), v = Kind<TestType>::make(0);
      integrate::spring_exact(x, v, h, omega, zeta);
      right(Kind<TestType>::read(x), expected(0, 0) * start, start, 16);
      right(Kind<TestType>::read(v), expected(1, 0) * omega * start, angle * omega * start, 16);
      x = Kind<TestType>::make(0), v = Kind<TestType>::make(start);
      integrate::spring_exact(x, v, h, omega, zeta);
      right(Kind<TestType>::read(x), expected(0, 1) / omega * start, h * start, 16);
      right(Kind<TestType>::read(v), expected(1, 1) * start, start, 16);
    });
  }
}
