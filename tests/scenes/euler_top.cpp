// SPDX-License-Identifier: MIT-0
#include "scenes/euler_top.h"

#include <catch2/catch_test_macros.hpp>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "equation.h"

namespace {

using scenes::EulerTop;
using Real = EulerTop::Real;
using Vec = EulerTop::Vec;
using Matrix = EulerTop::Matrix;

constexpr Real rounding = std::numeric_limits<Real>::epsilon();

// Each axis as the lowest, the middle and the highest moment, and spins on either side of the
// separatrix and near it, about every axis and either way.
std::vector<EulerTop> tops() {
  std::vector<EulerTop> all = {{},
                               {Vec(1, 2, 3), Vec(1e-6L, 20, 0)},
                               {Vec(1, 1, 2), Vec(3, -4, 5)},
                               {Vec(2, 1, 2), Vec(3, -4, 5)},
                               {Vec(1, 1, 1e-4L), Vec(3, -4, 5)}};
  for (const Vec& inertia : {Vec(1, 2, 2.5L), Vec(2, 1, 2.5L), Vec(2.5L, 2, 1), Vec(2, 2.5L, 1)}) {
    for (const Vec& w :
         {Vec(6, 1, 2), Vec(-6, 1, 2), Vec(1, -6, 2), Vec(2, 1, -6), Vec(-3, -3, 3)}) {
      all.push_back({inertia, w});
    }
  }
  return all;
}

}  // namespace

TEST_CASE("A top's exact spin begins at its start and obeys Euler's equations") {
  for (const EulerTop& top : tops()) {
    CHECK((top.spin(0) - top.w).norm() < 8 * rounding * top.w.norm());
    for (const Real t : {-2.0L, -0.3L, 0.1L, 1.7L}) {
      const Vec w = top.spin(t);
      const auto spin = [&](Real at) -> Vec { return top.spin(at); };
      // The differences are of order 8, over a thousandth of a second.
      CHECK((equation::slope(spin, t) - top(Vec::Zero(), w, t)).norm() < 1e-12L * w.squaredNorm());
    }
  }
}

TEST_CASE("A top's exact orientation begins at its start and turns as its spin says") {
  for (const EulerTop& top : tops()) {
    CHECK((top.orientation(0) - Matrix::Identity()).norm() < 16 * rounding);
    for (const Real t : {-2.0L, 0.1L, 1.7L}) {
      const Matrix R = top.orientation(t);
      const auto turned = [&](Real at) -> Matrix { return top.orientation(at); };
      const Matrix slope = R * EulerTop::crossing(top.spin(t));
      CHECK((equation::slope(turned, t) - slope).norm() < 2e-12L * slope.norm());
    }
  }
}

TEST_CASE("A top's exact solution keeps its energy and its angular momentum") {
  for (const EulerTop& top : tops()) {
    const Vec L = top.inertia.cwiseProduct(top.w);
    for (const Real t : {-2.0L, 0.1L, 1.7L, 10.0L}) {
      const Vec w = top.spin(t);
      CHECK(std::abs(top.energy(w) - top.energy(top.w)) < 1e-16L * top.energy(w));
      CHECK((top.orientation(t) * top.inertia.cwiseProduct(w) - L).norm() < 1e-16L * L.norm());
    }
  }
}

TEST_CASE("A top with two equal moments precesses like a coin") {
  const EulerTop coin{Vec(1, 1, 2), Vec(0.3L, 0.4L, 6)};
  for (const Real t : {-1.0L, 0.4L, 3.0L}) {
    // The spin goes round the axis at (I3 - I1) / I1 of the spin about it.
    const Real c = std::cos(6 * t), s = std::sin(6 * t);
    const Vec truth(0.3L * c - 0.4L * s, 0.3L * s + 0.4L * c, 6);
    CHECK((coin.spin(t) - truth).norm() < 1e-17L * 60);
    // And the axis round the angular momentum, at |L| / I1.
    const Vec L = coin.inertia.cwiseProduct(coin.w);
    const Vec axis = Eigen::AngleAxis<Real>(L.norm() * t, L.normalized()) * Vec::UnitZ();
    CHECK((coin.orientation(t) * Vec::UnitZ() - axis).norm() < 1e-15L);
  }
}
