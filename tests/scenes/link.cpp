// SPDX-License-Identifier: MIT-0
#include "scenes/link.h"

#include <catch2/catch_test_macros.hpp>

#include "differences.h"

using Eigen::Matrix3d;
using Eigen::Vector3d;
using scenes::Link;

namespace {

constexpr Link<> spring{.length = 2, .k = 7, .c = 0.7};

}  // namespace

TEST_CASE("A link pulls when it is long, pushes when it is short, and brakes along itself") {
  const Vector3d still = Vector3d::Zero();
  CHECK(spring.pull({0, 3, 0}, still) == Vector3d(0, 7, 0));
  CHECK(spring.pull({0, 1, 0}, still) == Vector3d(0, -7, 0));
  CHECK(spring.pull({0, 2, 0}, still) == still);
  CHECK(spring.pull({0, 2, 0}, {5, 10, 5}) == Vector3d(0, 7, 0));
  CHECK(spring.energy({0, 0, 5}) == 7 * 9 / 2.0);
}

TEST_CASE("A link's damping is the derivative of its pull by the velocity, long or short") {
  for (const Vector3d& d : {Vector3d(1, -2, 1.5), Vector3d(0.3, 0.4, -0.5)}) {
    const auto pull = [&](const Eigen::VectorXd& w) { return spring.pull(d, w); };
    const auto slope = differences::slopes(pull, Vector3d(0.2, 0.5, -1));
    CHECK((spring.damping(d) - slope.matrix).cwiseAbs().maxCoeff() < slope.rounding);
  }
}

TEST_CASE("A link's stiffness is the derivative of its pull, short of what compression adds") {
  const auto pull = [](const Eigen::VectorXd& d) { return spring.pull(d, Vector3d::Zero()); };
  const Vector3d long_one(1, -2, 1.5);
  const auto slope = differences::slopes(pull, long_one);
  CHECK((spring.stiffness(long_one) - slope.matrix).cwiseAbs().maxCoeff() < slope.rounding);

  const Vector3d short_one(0.6, 0, -0.8);
  const Matrix3d along = short_one * short_one.transpose();
  const auto all = differences::slopes(pull, short_one);
  CHECK((all.matrix * short_one - 7 * short_one).norm() < 3 * all.rounding);
  CHECK((all.matrix + 7 * (Matrix3d::Identity() - 2 * along)).norm() < 9 * all.rounding);
  CHECK((spring.stiffness(short_one) - 7 * along).norm() < 1e-14);
}
