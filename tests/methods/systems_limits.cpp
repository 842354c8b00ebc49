// SPDX-License-Identifier: MIT-0
// The linear systems where they are small, and what a SparseSystem calls symmetric.
#include <Eigen/Core>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "integrate/band_system.h"
#include "integrate/dense_system.h"
#include "integrate/sparse_system.h"

using Catch::Matchers::ContainsSubstring;
using Eigen::VectorXd;

namespace {

// Masses in a row, each tied to all within `reach` of it.
auto row_of_masses(int reach) {
  return [reach](const VectorXd& x, const VectorXd&, double, auto&& add) {
    const int count = int(x.size());
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        if (std::abs(i - j) <= reach) add(i, j, i == j ? -12.0 : 1.0 / (1 + i + j), 0.0);
      }
    }
  };
}

VectorXd counted(int count) {
  return VectorXd::LinSpaced(count, 1, count);
}

template <class System>
VectorXd solution(System&& system, int count) {
  VectorXd change = counted(count);
  REQUIRE(system(counted(count), counted(count), 0.0, -1.0, 0.0, change));
  return change;
}

// Two masses whose coupling is the sum of three entries; `first` and `second` are the factors by
// which the two directions of it were computed.
auto coupled(double first, double second, double rest) {
  return [=](const VectorXd&, const VectorXd&, double, auto&& add) {
    for (const double part : {0.1, 0.2, rest}) {
      add(0, 1, part / first, 0.0);
      add(1, 0, part / second, 0.0);
    }
  };
}

template <class Jacobian>
std::string problem(const Jacobian& jacobian, const VectorXd& masses, double right_side = 1) {
  integrate::SparseSystem<Jacobian> system(jacobian, masses);
  VectorXd change = VectorXd::Constant(2, right_side);
  const bool solved = system(VectorXd::Zero(2), VectorXd::Zero(2), 0.0, -1.0, 0.0, change);
  CHECK(solved == std::string(system.problem()).empty());
  return system.problem();
}

}  // namespace

TEST_CASE("Systems without an unknown have been solved") {
  const auto jacobian = row_of_masses(1);
  using Jacobian = decltype(jacobian);
  CHECK(solution(integrate::DenseSystem<Jacobian>(jacobian), 0).size() == 0);
  CHECK(solution(integrate::BandSystem<1, Jacobian>(jacobian), 0).size() == 0);
  CHECK(solution(integrate::SparseSystem<Jacobian>(jacobian), 0).size() == 0);
}

// Of condition less than 1.3, so that no solution is off by more than some tens of roundings.
TEST_CASE("A BandSystem may be wider than its matrix") {
  const auto jacobian = row_of_masses(5);
  using Jacobian = decltype(jacobian);
  for (int count = 1; count <= 7; ++count) {
    CAPTURE(count);
    const VectorXd known = solution(integrate::DenseSystem<Jacobian>(jacobian), count);
    const VectorXd mine = solution(integrate::BandSystem<5, Jacobian>(jacobian), count);
    CHECK((mine - known).norm() < 1e-14 * known.norm());
  }
}

TEST_CASE("A SparseSystem with masses for another number of unknowns refuses and says so") {
  const auto jacobian = coupled(1, 1, 0.1);
  CHECK(problem(jacobian, VectorXd::Ones(2)).empty());
  CHECK_THAT(problem(jacobian, VectorXd::Ones(1)), ContainsSubstring("one mass for each unknown"));
  CHECK_THAT(problem(jacobian, VectorXd::Ones(3)), ContainsSubstring("one mass for each unknown"));
}

TEST_CASE("A SparseSystem says of what is not finite that it is not") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinite, -infinite}) {
    CAPTURE(bad);
    CHECK_THAT(problem(coupled(1, 1, bad), {}), ContainsSubstring("Jacobian or a mass is not fin"));
    CHECK_THAT(problem(coupled(1, 1, 0.1), VectorXd::Constant(2, bad)),
               ContainsSubstring("Jacobian or a mass is not fin"));
    CHECK_THAT(problem(coupled(1, 1, 0.1), {}, bad), ContainsSubstring("change"));
  }
}

TEST_CASE("A SparseSystem calls symmetric what differs by rounding, also where the sum cancels") {
  const VectorXd masses{{3, 19}};
  CHECK(3 * (0.1 / 3) + 3 * (0.2 / 3) + 3 * (-0.3 / 3) !=
        19 * (0.1 / 19) + 19 * (0.2 / 19) + 19 * (-0.3 / 19));
  CHECK(problem(coupled(3, 19, -0.3), masses).empty());
  CHECK_THAT(problem(coupled(3, 19 * (1 + 1e-6), 0.1), masses), ContainsSubstring("not symmetric"));
}

TEST_CASE("A SparseSystem takes a Jacobian by differences, which is right to half of its digits") {
  CHECK(problem(coupled(1, 1 + 1e-9, 0.1), {}).empty());
  CHECK_THAT(problem(coupled(1, 1 + 1e-6, 0.1), {}), ContainsSubstring("not symmetric"));
}

TEST_CASE("A coupling too soft to be seen beside the diagonal is still checked for symmetry") {
  const auto jacobian = [](const VectorXd&, const VectorXd&, double, auto&& add) {
    for (const int i : {0, 1}) add(i, i, -1e8, 0.0);
    add(0, 1, 1e-2, 0.0);
    add(1, 0, 1e-4, 0.0);
  };
  CHECK_THAT(problem(jacobian, {}), ContainsSubstring("not symmetric"));
}

TEST_CASE("A SparseSystem refuses a Jacobian that adds other entries each time") {
  int calls = 0;
  const auto jacobian = [&calls](const VectorXd&, const VectorXd&, double, auto&& add) {
    const int i = ++calls % 2;
    add(i, i, -1.0, 0.0);
  };
  CHECK_THAT(problem(jacobian, {}), ContainsSubstring("same entries"));
}
