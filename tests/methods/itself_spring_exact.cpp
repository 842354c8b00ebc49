// SPDX-License-Identifier: MIT-0
// The closed form of the spring against other closed forms, to rounding, whatever the spring.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>

#include "integrate/spring_exact.h"
#include "textbook/exponential.h"

using Catch::Matchers::WithinAbs;

namespace {

using textbook::Matrix;
using textbook::Real;

// The motion from unit position and from unit velocity: (xx, xv; vx, vv).
struct Spring {
  Real omega, zeta;

  // The sum of two exponentials with the roots of r^2 + 2 zeta omega r + omega^2.
  Matrix creeping(Real h) const {
    const Real fast = -omega * (zeta + std::sqrt(zeta * zeta - 1));
    const Real slow = omega * omega / fast;
    const Real e_fast = std::exp(fast * h), e_slow = std::exp(slow * h);
    Matrix m;
    m << slow * e_fast - fast * e_slow, e_slow - e_fast,  //
        omega * omega * (e_fast - e_slow), slow * e_slow - fast * e_fast;
    return m / (slow - fast);
  }

  // A sine and a cosine that decay, by amplitude and phase.
  Matrix swinging(Real h) const {
    const Real phase = std::asin(zeta), root = std::cos(phase);
    const Real angle = omega * root * h, left = std::exp(-zeta * omega * h) / root;
    Matrix m;
    m << left * std::cos(angle - phase), left * std::sin(angle) / omega,  //
        -left * omega * std::sin(angle), left * std::cos(angle + phase);
    return m;
  }

  // Series in (zeta^2 - 1) (omega h)^2: on both sides of critical damping the same.
  Matrix near_critical(Real h) const {
    const Real angle = omega * h, square = (zeta - 1) * (zeta + 1) * angle * angle;
    Real cosine = 1, sine = 1;
    for (int n = 12; n >= 1; --n) {
      cosine = 1 + cosine * square / (2 * n * (2 * n - 1));
      sine = 1 + sine * square / (2 * n * (2 * n + 1));
    }
    Matrix m;
    m << cosine + zeta * angle * sine, h * sine,  //
        -omega * angle * sine, cosine - zeta * angle * sine;
    return std::exp(-zeta * angle) * m;
  }

  // On the way from one form to the other, both are right to long double's rounding.
  Matrix motion(Real h) const {
    const Real apart = (zeta - 1) * (zeta + 1) * omega * omega * h * h;
    if (std::abs(apart) < 1) return near_critical(h);
    return zeta < 1 ? swinging(h) : creeping(h);
  }
};

// What rounding may do. A rate that is off by an epsilon is off by it once for each radian and each
// halving of the motion; apart from that, some ten roundings of the terms without their signs.
Matrix rounding(const Spring& s, Real h, Real epsilon) {
  const bool swings = s.zeta < 1;
  const Real root = std::sqrt(std::abs((s.zeta - 1) * (s.zeta + 1)));
  const Real decay = s.omega * (swings ? s.zeta : 1 / (s.zeta + root));
  const Real push = std::abs(s.motion(h)(0, 1));
  const Real left = std::exp(-decay * h);
  const Real last = swings ? left : std::exp(-(decay + 2 * s.omega * root) * h);
  Matrix terms;
  terms << left + decay * push, push, s.omega * s.omega * push, last + decay * push;
  const Real turned = 1 + std::abs(h) * (decay + s.omega * root);
  return 10 * epsilon * turned * terms;
}

template <class Vec>
void check_motion(Vec omega, Vec zeta, Vec h) {
  const Spring spring{omega, zeta};
  const Matrix expected = spring.motion(h);
  const Matrix apart = rounding(spring, h, std::numeric_limits<Vec>::epsilon());
  for (int column = 0; column < 2; ++column) {
    CAPTURE(omega, zeta, h, column);
    Vec x = column == 0 ? Vec(1) : Vec(0), v = Vec(1) - x;
    integrate::spring_exact(x, v, h, omega, zeta);
    const double smallest = double(std::numeric_limits<Vec>::min());
    CHECK_THAT(x, WithinAbs(double(expected(0, column)), double(apart(0, column)) + smallest));
    CHECK_THAT(v, WithinAbs(double(expected(1, column)), double(apart(1, column)) + smallest));
  }
}

}  // namespace

TEMPLATE_TEST_CASE("The exact spring is exact to rounding, whatever its damping and the step", "",
                   double, float) {
  for (const double zeta : {0.0, 1e-9, 0.1, 0.5, 0.99, 1 - 1e-6, 1 - 1e-12, 1.0, 1 + 1e-12,
                            1 + 1e-6, 1.01, 2.0, 10.0, 1e3}) {
    for (const double omega : {1e-6, 0.5, 3.0, 40.0}) {
      for (const double h : {0.0, 1e-12, 1e-3, 0.03, 0.3, 1.0, 7.0, 1e3, 1e6}) {
        check_motion(TestType(omega), TestType(zeta), TestType(h));
        // Backwards, as long as what has decayed can come back without overflow.
        if (2 * zeta * omega * h < 60) {
          check_motion(TestType(omega), TestType(zeta), TestType(-h));
        }
      }
    }
  }
}

TEST_CASE("Without stiffness the exact spring drifts on, damped or not") {
  for (const double zeta : {0.0, 0.5, 1.0, 1e3}) {
    for (const double h : {1e-9, 0.3, 1e6, -2.0}) {
      double x = 0.7, v = -1.1;
      integrate::spring_exact(x, v, h, 0.0, zeta);
      CHECK(x == 0.7 + h * -1.1);
      CHECK(v == -1.1);
    }
  }
}

TEMPLATE_TEST_CASE("The folded exact step takes the bits of the exact one", "", double, float) {
  for (const TestType zeta : {TestType(0), TestType(0.3), TestType(1), TestType(3)}) {
    for (const TestType h : {TestType(1e-6), TestType(0.02), TestType(-0.02), TestType(4)}) {
      const auto folded = integrate::spring_folded_start(h, TestType(7), zeta);
      TestType x = TestType(0.7), v = TestType(-1.1), exact_x = x, exact_v = v;
      for (int n = 0; n < 20; ++n) {
        integrate::spring_folded(x, v, folded);
        integrate::spring_exact(exact_x, exact_v, h, TestType(7), zeta);
      }
      CAPTURE(zeta, h);
      CHECK(x == exact_x);
      CHECK(v == exact_v);
    }
  }
}
