// SPDX-License-Identifier: MIT-0
#include "scenes/rope.h"

#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "differences.h"
#include "runge_kutta.h"

using Catch::Matchers::WithinRel;
using differences::random;
using Eigen::Vector3d;
using Eigen::VectorXd;
using scenes::node;
using scenes::Rope;

namespace {

constexpr int count = 6;
constexpr Rope<> undamped{.count = count, .length = 5, .mass = 2, .tip = 3, .k = 7};
constexpr Rope<> free_in_space{.count = count,
                               .length = 5,
                               .mass = 2,
                               .tip = 3,
                               .k = 7,
                               .c = 0.7,
                               .g = 0,
                               .first_held = false};

VectorXd crumpled() {
  return undamped.start().x + random(3 * count, 0.3, 1);
}
VectorXd moving() {
  return random(3 * count, 2, 2);
}

}  // namespace

TEST_CASE("A rope accelerates down the gradient of its energy, but where it is held") {
  const auto energy = [](const VectorXd& there) { return undamped.energy(there, moving()); };
  const auto slope = differences::gradient(energy, crumpled());
  const VectorXd force = undamped.masses().cwiseProduct(undamped(crumpled(), moving(), 0.0));
  const VectorXd wanted = -slope.matrix.transpose();
  CHECK((force - wanted).tail(3 * (count - 1)).cwiseAbs().maxCoeff() < slope.rounding);
  CHECK(slope.rounding < 1e-9);
  CHECK(node(force, 0) == Vector3d::Zero());
}

TEST_CASE("A rope may be held at its first mass, its last, both or neither") {
  for (const bool first : {false, true}) {
    for (const bool last : {false, true}) {
      Rope<> rope = undamped;
      rope.first_held = first;
      rope.last_held = last;
      const VectorXd a = rope(crumpled(), moving(), 0.0);
      for (int i = 0; i < count; ++i) {
        CAPTURE(first, last, i);
        const bool held = (first && i == 0) || (last && i == count - 1);
        CHECK((node(a, i) == Vector3d::Zero()) == held);
      }
    }
  }
}

TEST_CASE("A rope that is thrown keeps its momentum and its angular momentum, damped or not") {
  const VectorXd x = crumpled(), v = moving();
  const VectorXd force = free_in_space.masses().cwiseProduct(free_in_space(x, v, 0.0));
  Vector3d sum = Vector3d::Zero(), turn = Vector3d::Zero();
  for (int i = 0; i < count; ++i) {
    const Vector3d here = node(x, i), pull = node(force, i);
    sum += pull;
    turn += here.cross(pull);
  }
  CHECK(force.norm() > 1);
  CHECK(sum.norm() < 1e-14 * force.norm());
  CHECK(turn.norm() < 1e-14 * force.norm() * x.norm());
}

TEST_CASE("Gravity pulls all masses of a rope alike") {
  Rope<> on_earth = free_in_space;
  on_earth.g = 9.81;
  const VectorXd more =
      on_earth(crumpled(), moving(), 0.0) - free_in_space(crumpled(), moving(), 0.0);
  for (int i = 0; i < count; ++i) CHECK((node(more, i) - Vector3d(0, -9.81, 0)).norm() < 1e-14);
}

TEST_CASE("A damped rope loses what its springs take, by the squares of their speeds") {
  const VectorXd x = crumpled(), v = moving();
  Rope<> no_damping = free_in_space;
  no_damping.c = 0;
  const VectorXd brake = free_in_space(x, v, 0.0) - no_damping(x, v, 0.0);
  double squares = 0;
  for (int i = 1; i < count; ++i) {
    const Vector3d apart = node(x, i) - node(x, i - 1);
    squares += std::pow(apart.normalized().dot(node(v, i) - node(v, i - 1)), 2);
  }
  CHECK_THAT(v.dot(free_in_space.masses().cwiseProduct(brake)), WithinRel(-0.7 * squares, 1e-13));
}

TEST_CASE("A rope at rest in space stays as it is") {
  Rope<> rope = free_in_space;
  const auto start = rope.start();
  CHECK(rope(start.x, start.v, 0.0).cwiseAbs().maxCoeff() < 1e-14);
  CHECK(node(start.x, count - 1) == Vector3d(5, 0, 0));
}

TEST_CASE("A rope hangs still where each spring carries what is below it") {
  VectorXd x = VectorXd::Zero(3 * count);
  for (int i = 1; i < count; ++i) {
    const double below = 2 * (count - 1 - i) + 3;
    x[3 * i + 1] = x[3 * i - 2] - (1 + below * 9.81 / 7);
  }
  CHECK(undamped(x, VectorXd::Zero(x.size()), 0.0).cwiseAbs().maxCoeff() < 1e-13);
}

// A method of order four takes the error of the energy down by sixteen when its step is halved;
// what a wrong formula gained or lost would stay.
TEST_CASE("A rope that swings keeps its energy, up to the error of the steps") {
  Rope<> swing = undamped;
  swing.k = 700;
  const auto start = swing.start();
  const auto gained = [&](int steps) {
    const auto end = runge_kutta(swing, start, 2, steps);
    CHECK(node(end.x, count - 1).x() < 0);
    return std::abs(swing.energy(end.x, end.v) - swing.energy(start.x, start.v));
  };
  const double coarse = gained(500);
  CHECK(coarse < 1e-4);
  CHECK(gained(1000) < coarse / 8);
}
