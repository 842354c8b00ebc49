// SPDX-License-Identifier: MIT-0
// Pushes at a corner of a body.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>

#include "orientation_try.h"

TEMPLATE_TEST_CASE("A push at a corner moves it as the equations of the whole body have it", "",
                   float, double) {
  // Seven unknowns: how much faster the body gets, how much faster it spins, and the push that
  // makes the corner faster by one.
  for (const V& moments : bodies()) {
    for (int n = 0; n < 20; ++n) {
      const auto q = some_orientation<TestType>();
      const auto inertia = vec<TestType>(moments), up = vec<TestType>(direction());
      const auto r = vec<TestType>(number(0, 2) * direction());
      const TestType inverse_mass = TestType(number(0.01L, 10));
      Eigen::Matrix<Long, 7, 7> A = Eigen::Matrix<Long, 7, 7>::Zero();
      A.topLeftCorner<3, 3>() = M::Identity() / inverse_mass;
      A.block<3, 3>(3, 3) = matrix(q) * exact(inertia).asDiagonal() * matrix(q).transpose();
      A.block<3, 1>(0, 6) = -exact(up);
      A.block<3, 1>(3, 6) = -exact(r).cross(exact(up));
      A.bottomLeftCorner<1, 6>() = -A.topRightCorner<6, 1>().transpose();
      const Eigen::Matrix<Long, 7, 1> one = Eigen::Matrix<Long, 7, 1>::Unit(6);
      const Long push = A.fullPivLu().solve(one)[6];
      const Long found = shelf::inverse_mass_at(q, inertia, inverse_mass, r, up);
      const Long bound = inverse_mass + exact(r).squaredNorm() / moments.minCoeff();
      CHECK(std::abs(found - 1 / push) < 20 * rounding<TestType> * bound);
    }
  }
}

TEMPLATE_TEST_CASE(
    "A pushed corner leaves with its share of its speed, and a whole share wastes "
    "no energy",
    "", float, double) {
  for (const Long e : {0.0L, 0.4L, 1.0L}) {
    for (int n = 0; n < 100; ++n) {
      const auto q = some_orientation<TestType>();
      const auto inertia = shelf::inertia_of_box(TestType(20), {0.5f, 1, 0.75f});
      const auto r = rotate(q, {n & 1 ? 0.25f : -0.25f, n & 2 ? 0.5f : -0.5f, 0.375f});
      const auto up = vec<TestType>(direction());
      auto v = vec<TestType>(4 * direction()), L = vec<TestType>(6 * direction());
      const M R = matrix(q), tensor = R * exact(inertia).asDiagonal() * R.transpose();
      const auto spin = [&]() -> V { return tensor.inverse() * exact(L); };
      const auto rises = [&] { return (exact(v) + spin().cross(exact(r))).dot(exact(up)); };
      const auto energy = [&] { return 10 * exact(v).squaredNorm() + spin().dot(exact(L)) / 2; };
      const auto about_corner = [&]() -> V { return exact(L) - exact(r).cross(20 * exact(v)); };
      const Long speed = -rises(), before = energy();
      const V momentum = about_corner();
      const TestType J =
          TestType((1 + e) * speed) / shelf::inverse_mass_at(q, inertia, TestType(0.05L), r, up);
      v = v + (J / TestType(20)) * up;
      L = L + cross(r, J * up);
      CHECK(std::abs(rises() - e * speed) < 100 * rounding<TestType>);
      if (e == 1) CHECK(std::abs(energy() / before - 1) < 20 * rounding<TestType>);
      CHECK((about_corner() - momentum).norm() < 400 * rounding<TestType>);
    }
  }
}

TEST_CASE("A push straight through the centre turns nothing, and what can't move doesn't") {
  const shelf::Vec3<double> inertia{1, 2, 3}, nowhere, up{0, 1, 0};
  const shelf::Quaternion<double> q{0.5, 0.5, -0.5, 0.5};
  CHECK(shelf::inverse_mass_at(q, inertia, 0.25, nowhere, up) == 0.25);
  CHECK(shelf::inverse_mass_at(q, inertia, 0.25, {0, -3, 0}, up) == 0.25);
  const double never = std::numeric_limits<double>::infinity();
  CHECK(shelf::inverse_mass_at(q, {never, never, never}, 0, {1, 2, 3}, up) == 0);
  constexpr float ahead =
      shelf::inverse_mass_at(shelf::Quaternion<float>{}, {1, 2, 4}, 1, {3, 0, 0}, {0, 0, 1});
  CHECK(ahead == 5.5f);
}
