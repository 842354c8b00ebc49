// SPDX-License-Identifier: MIT-0
// Turns, and the vectors and moments that they turn.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>

#include "integrate/rk4.h"
#include "orientation_try.h"

using Catch::Matchers::WithinAbs;

TEMPLATE_TEST_CASE("A turn by the first order covers twice an arc tangent, about the right axis",
                   "", float, double) {
  for (const Long angle : {1e-6L, 1e-4L, 0.01L, 0.3L, 1.0L, 3.0L, 100.0L}) {
    for (int n = 0; n < 20; ++n) {
      const V axis = direction();
      const Long h = number(0.001L, 0.1L);
      auto q = some_orientation<TestType>();
      const M truth = about(axis, 2 * std::atan(angle / 2)) * matrix(q);
      shelf::turn(q, vec<TestType>(angle / h * axis), TestType(h));
      CHECK(EulerTop::angle_between(matrix(q), truth) < 4 * rounding<TestType>);
    }
  }
}

TEMPLATE_TEST_CASE("An exact turn is right to rounding, from small angles to large", "", float,
                   double) {
  for (const Long angle : {1e-6L, 1e-4L, 0.01L, 0.3L, 1.0L, 3.0L, 6.0L}) {
    for (int n = 0; n < 20; ++n) {
      const V axis = direction();
      const Long h = number(0.001L, 0.1L) * (n % 2 ? 1 : -1);
      auto q = some_orientation<TestType>();
      const M truth = about(axis, angle) * matrix(q);
      shelf::turn_exact(q, vec<TestType>(angle / h * axis), TestType(h));
      CHECK(EulerTop::angle_between(matrix(q), truth) < (4 + angle) * rounding<TestType>);
    }
  }
}

TEMPLATE_TEST_CASE("No turn is too slow to be seen, but for rounding", "", float, double) {
  // From an orientation that has room for small numbers.
  for (Long angle = 1e-3L; angle > std::numeric_limits<TestType>::min() * 100; angle /= 10) {
    shelf::Quaternion<TestType> slow, first;
    shelf::turn_exact(slow, {TestType(angle), 0, 0}, TestType(0.5L));
    shelf::turn(first, {0, TestType(angle), 0}, TestType(-0.5L));
    CHECK(std::abs(slow.x - std::sin(Long(TestType(angle)) / 4)) <= rounding<TestType> * angle);
    CHECK(std::abs(first.y + std::sin(std::atan(Long(TestType(angle)) / 4))) <=
          rounding<TestType> * angle);
  }
  shelf::Quaternion<TestType> still;
  shelf::turn_exact(still, {}, TestType(1));
  CHECK((still.w == 1 && still.x == 0 && still.y == 0 && still.z == 0));
}

TEMPLATE_TEST_CASE("A quaternion keeps length one for a hundred thousand turns", "", float,
                   double) {
  auto first = some_orientation<TestType>(), exactly = first;
  Body<TestType> rotations, midpoint, bullet;
  for (int n = 0; n < 100'000; ++n) {
    const auto w = vec<TestType>(20 * direction());
    const TestType h = TestType(number(0.001L, 0.1L));
    shelf::turn(first, w, h);
    shelf::turn_exact(exactly, w, h);
    by_rotations(rotations, h), by_midpoint(midpoint, h), by_bullet(bullet, h);
    for (const auto& q : {first, exactly, rotations.q, midpoint.q, bullet.q}) {
      if (std::abs(length(q) - 1) < 2 * rounding<TestType>) continue;
      FAIL("length " << double(length(q)) << " after " << n << " steps");
    }
  }
}

TEMPLATE_TEST_CASE("Quaternions turn vectors as matrices do", "", float, double) {
  for (int n = 0; n < 50; ++n) {
    const auto a = some_orientation<TestType>(), b = some_orientation<TestType>();
    const V v = exact(vec<TestType>(3 * direction()));
    const M to_world = exact(a).toRotationMatrix();
    CHECK((exact(rotate(a, vec<TestType>(v))) - to_world * v).norm() < 12 * rounding<TestType>);
    CHECK((exact(rotate_back(a, vec<TestType>(v))) - to_world.transpose() * v).norm() <
          12 * rounding<TestType>);
    CHECK((exact(a * b).coeffs() - (exact(a) * exact(b)).coeffs()).norm() < 4 * rounding<TestType>);
    CHECK(std::abs(dot(vec<TestType>(v), rotate(a, {1, 2, 3})) - v.dot(to_world * V(1, 2, 3))) <
          40 * rounding<TestType>);
  }
  CHECK(std::abs(length(normalised(shelf::Quaternion<TestType>{3, -4, 12, 84})) - 1) <
        2 * rounding<TestType>);
}

TEST_CASE("A box's moments are those of eight masses that stand for it") {
  // Gauss's points: they give the integral of a square over an edge exactly.
  const V size(0.2L, 0.14L, 0.03L);
  const Long mass = 1.7L;
  V sum = V::Zero();
  for (int n = 0; n < 8; ++n) {
    const V sign(n & 1 ? 1 : -1, n & 2 ? 1 : -1, n & 4 ? 1 : -1);
    const V at = sign.cwiseProduct(size) / (2 * std::sqrt(Long(3)));
    for (int i = 0; i < 3; ++i) sum[i] += mass / 8 * (at.squaredNorm() - at[i] * at[i]);
  }
  const V found = exact(shelf::inertia_of_box(1.7, {0.2, 0.14, 0.03}));
  CHECK((found - sum).norm() < 4 * rounding<double> * sum.norm());
  constexpr shelf::Vec3<float> cube = shelf::inertia_of_box(6.0f, {1, 1, 1});
  CHECK((cube.x == 1 && cube.y == 1 && cube.z == 1));
}

TEMPLATE_TEST_CASE("Angular momentum and velocity follow from each other", "", float, double) {
  for (const V& moments : bodies()) {
    const auto q = some_orientation<TestType>();
    const auto w = vec<TestType>(5 * direction()), inertia = vec<TestType>(moments);
    const M R = exact(q).toRotationMatrix();
    const M tensor = R * exact(inertia).asDiagonal() * R.transpose();
    const auto L = angular_momentum(q, w, inertia);
    const Long bound = 40 * rounding<TestType> * moments.maxCoeff();
    CHECK((exact(L) - tensor * exact(w)).norm() < bound);
    CHECK((exact(angular_velocity(q, L, inertia)) - exact(w)).norm() <
          4 * bound / moments.minCoeff());
  }
}

TEST_CASE("Products and sums of vectors and quaternions can be called by their full names") {
  constexpr shelf::Vec3<float> x{1, 0, 0};
  static_assert(shelf::dot(x, {3, 2, 1}) == 3);
  static_assert(shelf::cross(x, {0, 1, 0}).z == 1);
  static_assert((0.25 * x + 2 * x).x == 2.25f);
  static_assert((shelf::Quaternion<float>{0, 1} * shelf::Quaternion<float>{0, 1}).w == -1);
  CHECK(shelf::normalised(shelf::Quaternion<double>{0, 0, -4, 3}).y == -0.8);
}

TEST_CASE("The methods of this book step a Vec3") {
  // Euler's equations, seen from the body: RK4 keeps the energy well, but not for ever.
  using Vec = shelf::Vec3<double>;
  const auto gyroscopic = [](const Vec&, const Vec& w, double) -> Vec {
    const Vec torque = cross(Vec{1 * w.x, 2 * w.y, 3 * w.z}, w);
    return {torque.x / 1, torque.y / 2, torque.z / 3};
  };
  const auto energy = [](const Vec& w) { return w.x * w.x + 2 * w.y * w.y + 3 * w.z * w.z; };
  Vec nowhere, w{0.2, 20, 0.2};
  const double first = energy(w);
  for (int n = 0; n < 600; ++n) integrate::rk4(nowhere, w, n / 60.0, 1 / 60.0, gyroscopic);
  CHECK_THAT(energy(w) / first, WithinAbs(0.9999, 0.0001));
  CHECK(energy(w) < first * (1 - 1e-6));
}
