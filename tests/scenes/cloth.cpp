// SPDX-License-Identifier: MIT-0
#include "scenes/cloth.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <set>
#include <utility>

#include "differences.h"
#include "runge_kutta.h"

using Catch::Matchers::WithinRel;
using differences::random;
using Eigen::Vector3d;
using Eigen::VectorXd;
using scenes::Cloth;
using scenes::node;

namespace {

constexpr int side = 5;
constexpr Cloth<> undamped{.side = side, .width = 4, .mass = 2, .k = 7};
constexpr Cloth<> in_space{.side = side, .width = 4, .mass = 2, .k = 7, .c = 0.7, .g = 0};

VectorXd crumpled() {
  return undamped.start().x + random(3 * side * side, 0.3, 1);
}
VectorXd moving() {
  return random(3 * side * side, 2, 2);
}
bool is_corner(int i) {
  return i == 0 || i == side - 1;
}

}  // namespace

TEST_CASE("A cloth accelerates down the gradient of its energy, but where it is held") {
  const auto energy = [](const VectorXd& there) { return undamped.energy(there, moving()); };
  const auto slope = differences::gradient(energy, crumpled());
  const VectorXd force = 2 * undamped(crumpled(), moving(), 0.0);
  const VectorXd wanted = -slope.matrix.transpose();
  CHECK(slope.rounding < 1e-8);
  for (int i = 0; i < side * side; ++i) {
    CAPTURE(i);
    if (is_corner(i)) {
      CHECK(node(force, i) == Vector3d::Zero());
    } else {
      CHECK((node(force, i) - node(wanted, i)).cwiseAbs().maxCoeff() < slope.rounding);
    }
  }
}

TEST_CASE("Each mass of a cloth is tied to its eight neighbours, once, at rest where it starts") {
  const VectorXd start = undamped.start().x;
  std::set<std::pair<int, int>> seen;
  undamped.for_each_link([&](int i, int j, const auto& link) {
    CAPTURE(i, j);
    CHECK(seen.emplace(std::minmax(i, j)).second);
    const double away = (node(start, j) - node(start, i)).norm();
    CHECK(away < 1.5);
    CHECK_THAT(link.length, WithinRel(away, 1e-15));
  });
  CHECK(seen.size() == 2 * side * (side - 1) + 2 * (side - 1) * (side - 1));
}

TEST_CASE("Inner forces of a cloth, damping among them, leave its momentum as it is") {
  VectorXd x = crumpled(), v = moving();
  x.head(6 * side) = undamped.start().x.head(6 * side);  // nothing pulls at the corners
  v.head(6 * side).setZero();
  const VectorXd a = in_space(x, v, 0.0);
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i < side * side; ++i) sum += node(a, i);
  CHECK(a.norm() > 1);
  CHECK(sum.norm() < 1e-14 * a.norm());
}

TEST_CASE("A flat cloth in space stays as it is, and falls but for its corners on earth") {
  const auto start = undamped.start();
  CHECK(in_space(start.x, start.v, 0.0).cwiseAbs().maxCoeff() < 1e-14);
  const VectorXd a = undamped(start.x, start.v, 0.0);
  for (int i = 0; i < side * side; ++i) {
    CAPTURE(i);
    const Vector3d fall = is_corner(i) ? Vector3d(0, 0, 0) : Vector3d(0, -9.81, 0);
    CHECK((node(a, i) - fall).norm() < 1e-14);
  }
}

TEST_CASE("A damped cloth loses what its springs take, by the squares of their speeds") {
  const VectorXd x = crumpled();
  VectorXd v = moving();
  for (int i = 0; i < 3; ++i) v[i] = v[3 * (side - 1) + i] = 0;
  Cloth<> no_damping = in_space;
  no_damping.c = 0;
  const VectorXd brake = in_space(x, v, 0.0) - no_damping(x, v, 0.0);
  double squares = 0;
  in_space.for_each_link([&](int i, int j, const auto&) {
    const Vector3d apart = node(x, j) - node(x, i);
    squares += std::pow(apart.normalized().dot(node(v, j) - node(v, i)), 2);
  });
  CHECK_THAT(2 * v.dot(brake), WithinRel(-0.7 * squares, 1e-13));
}

// A method of order four takes the error of the energy down by sixteen when its step is halved;
// what a wrong formula gained or lost would stay.
TEST_CASE("A cloth that swings keeps its corners, and its energy up to the error of the steps") {
  Cloth<> swing = undamped;
  swing.k = 700;
  const auto start = swing.start();
  const auto gained = [&](int steps) {
    const auto end = runge_kutta(swing, start, 2, steps);
    CHECK(node(end.x, 0) == node(start.x, 0));
    CHECK(node(end.x, side - 1) == node(start.x, side - 1));
    CHECK(node(end.x, side * side - 1).z() < 0);
    return std::abs(swing.energy(end.x, end.v) - swing.energy(start.x, start.v));
  };
  const double coarse = gained(500);
  CHECK(coarse < 1e-4);
  CHECK(gained(1000) < coarse / 8);
}
