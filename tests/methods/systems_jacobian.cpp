// SPDX-License-Identifier: MIT-0
// What the linear systems do with a Jacobian that they are given.
#include <Eigen/Core>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include "integrate/band_system.h"
#include "integrate/dense_system.h"
#include "integrate/sparse_system.h"
#include "systems_try.h"

using namespace systems;
using integrate::BandSystem;
using integrate::DenseSystem;
using integrate::SparseSystem;

TEMPLATE_TEST_CASE("A DenseSystem may have a fixed size", "", double, float) {
  // With a Jacobian that is as full and as lopsided as can be.
  using Vec = Eigen::Matrix<TestType, 3, 1>;
  const auto jacobian = [](const auto&, const auto&, TestType, auto&& add) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) add(i, j, TestType(1 + 2 * i - j * j), TestType(3 * j - i));
    }
  };
  const Vec x = Vec::Zero();
  Vec change{TestType(1), TestType(-2), TestType(0.5)};
  const auto [y, rounding] = full_pivot(jacobian, x, x, -0.25, -0.5, change);
  DenseSystem<decltype(jacobian), TestType, 3> system(jacobian);
  REQUIRE(system(x, x, TestType(0), TestType(-0.25), TestType(-0.5), change));
  CHECK(double((change - y).norm()) <= rounding);
}

TEST_CASE("The systems take the Jacobian at the place, speed and time that they are given") {
  const auto jacobian = [](const auto& x, const auto& v, double t, auto&& add) {
    add(0, 0, -x[0] * t, -v[0]);
  };
  const Eigen::VectorXd x{{2.0}}, v{{5.0}};
  const auto check_one = [&](auto system) {
    Eigen::VectorXd change{{34.0}};
    REQUIRE(system(x, v, 3.0, -2.0, -1.0, change));  // 1 + 2 * 2 * 3 + 5 = 18
    CHECK(change[0] == 34.0 / 18);
  };
  check_one(DenseSystem<decltype(jacobian)>(jacobian));
  check_one(BandSystem<1, decltype(jacobian)>(jacobian));
  check_one(SparseSystem<decltype(jacobian)>(jacobian));
}
