// SPDX-License-Identifier: MIT-0
#include "scenes/chain.h"

#include <Eigen/Eigenvalues>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "differences.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using differences::random;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using scenes::Chain;

TEST_CASE("A chain accelerates down the gradient of its energy") {
  const Chain<> chain{.count = 6, .mass = 2, .tip = 5, .k = 3};
  const VectorXd x = random(6, 1, 1), v = random(6, 1, 2);
  const auto energy = [&](const VectorXd& there) { return chain.energy(there, v); };
  const auto slope = differences::gradient(energy, x);
  const VectorXd force = chain.masses().cwiseProduct(chain(x, v, 0.0));
  CHECK((force + slope.matrix.transpose()).cwiseAbs().maxCoeff() < slope.rounding);
  CHECK(slope.rounding < 1e-10);
}

TEST_CASE("What a damped chain loses goes into its springs, by the squares of their speeds") {
  const Chain<> chain{.count = 6, .mass = 2, .tip = 5, .k = 3, .c = 0.7};
  const Chain<> undamped{.count = 6, .mass = 2, .tip = 5, .k = 3};
  const VectorXd x = random(6, 1, 1), v = random(6, 1, 2);
  const VectorXd brake = chain(x, v, 0.0) - undamped(x, v, 0.0);
  double squares = v[0] * v[0];
  for (int i = 1; i < 6; ++i) squares += std::pow(v[i] - v[i - 1], 2);
  CHECK_THAT(v.dot(chain.masses().cwiseProduct(brake)), WithinRel(-0.7 * squares, 1e-14));
}

TEST_CASE("Only the wall changes the momentum of a chain") {
  const Chain<> chain{.count = 6, .mass = 2, .tip = 5, .k = 3, .c = 0.7};
  const VectorXd x = random(6, 1, 3), v = random(6, 1, 4);
  CHECK_THAT(chain.masses().dot(chain(x, v, 0.0)), WithinRel(-3 * x[0] - 0.7 * v[0], 1e-13));
}

TEST_CASE("A chain of one mass is a spring") {
  const Chain<> chain{.count = 1, .mass = 2, .k = 8, .c = 3};
  CHECK(chain(VectorXd::Constant(1, 0.5), VectorXd::Constant(1, 2), 0.0)[0] == -(4.0 + 6.0) / 2);
  CHECK_THAT(chain.frequency(1), WithinRel(2.0, 1e-15));
  CHECK(chain.energy(VectorXd::Constant(1, 0.5), VectorXd::Constant(1, 2)) == 1.0 + 4.0);
}

TEST_CASE("A chain that rests in its place stays there") {
  const Chain<> chain{.count = 6, .mass = 2, .tip = 5, .k = 3, .c = 0.7};
  CHECK(chain(VectorXd::Zero(6), VectorXd::Zero(6), 0.0) == VectorXd::Zero(6));
}

TEST_CASE("At the start every spring of a chain is stretched alike, so that only the end is free") {
  const Chain<> chain{.count = 6, .mass = 2, .tip = 5, .k = 3, .stretch = 0.25};
  const auto start = chain.start();
  const VectorXd a = chain(start.x, start.v, 0.0);
  CHECK(start.v == VectorXd::Zero(6));
  CHECK(a.head(5).cwiseAbs().maxCoeff() < 1e-15);
  CHECK_THAT(a[5], WithinRel(-3 * 0.25 / 5, 1e-14));
  CHECK_THAT(chain.energy(start.x, start.v), WithinRel(6 * 3 * 0.25 * 0.25 / 2, 1e-14));
}

// Eigenvalues of a symmetric matrix are right to a few roundings of the largest.
TEST_CASE("The modes of a chain have the frequencies 2 sqrt(k/m) sin((2j - 1) pi / (4n + 2))") {
  const Chain<> chain{.count = 9, .mass = 2, .k = 3};
  MatrixXd stiffness(9, 9);
  for (int j = 0; j < 9; ++j) {
    stiffness.col(j) = -chain(VectorXd::Unit(9, j), VectorXd::Zero(9), 0.0);
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(stiffness);
  for (int j = 1; j <= 9; ++j) {
    const double formula =
        2 * std::sqrt(3.0 / 2) * std::sin((2 * j - 1) * std::numbers::pi / (4 * 9 + 2));
    CAPTURE(j);
    CHECK_THAT(modes.eigenvalues()[j - 1], WithinAbs(formula * formula, 1e-14));
    CHECK_THAT(chain.frequency(j), WithinRel(formula, 1e-15));
  }
}

TEST_CASE("A heavy tip costs a chain's Jacobian its symmetry, and the masses give it back") {
  const Chain<> chain{.count = 4, .mass = 2, .tip = 50, .k = 3};
  MatrixXd all = MatrixXd::Zero(4, 4);
  chain.jacobian(VectorXd::Zero(4), VectorXd::Zero(4), 0.0,
                 [&](int i, int j, double dadx, double) { all(i, j) += dadx; });
  CHECK(all(2, 3) == 25 * all(3, 2));
  const MatrixXd weighted = chain.masses().asDiagonal() * all;
  CHECK((weighted - weighted.transpose()).cwiseAbs().maxCoeff() < 1e-15);
}
