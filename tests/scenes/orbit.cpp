// SPDX-License-Identifier: MIT-0
#include "scenes/orbit.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "equation.h"

using Catch::Matchers::WithinRel;
using Eigen::Vector2d;
using scenes::Orbit;

// Taylor series of the differential equation: see reference.py.
TEST_CASE("A planet is where Newton's equation takes it") {
  const Orbit<> planet{.eccentricity = 0.6, .semi_major = 3, .mu = 2};
  CHECK((planet.exact(0.5).x - Vector2d(1.0369819044811315906, 0.78037270014643092532)).norm() <
        1e-14);
  CHECK((planet.exact(0.5).v - Vector2d(-0.61369848110891999632, 1.4278727980202212285)).norm() <
        1e-14);
  CHECK((planet.exact(9).x - Vector2d(-4.5171139037111790254, 1.0173823774402692904)).norm() <
        1e-14);
  CHECK((planet.exact(9).v - Vector2d(-0.22425515415069352517, -0.3833063742140655895)).norm() <
        1e-14);
  const Orbit<> comet{.eccentricity = 0.9, .semi_major = 3, .mu = 2};
  CHECK((comet.exact(0.5).x - Vector2d(-0.50228317181143729325, 0.89011670088162747279)).norm() <
        1e-14);
  CHECK((comet.exact(9).v - Vector2d(-0.15973945201242864719, -0.1804936410072995774)).norm() <
        1e-14);
}

TEST_CASE("A planet obeys its equation, on a circle and on a long ellipse") {
  for (const long double e : {0.0L, 0.2L, 0.6L, 0.9L}) {
    const Orbit<long double> planet{.eccentricity = e, .semi_major = 3, .mu = 2};
    CHECK(equation::begins_at_start(planet));
    for (const long double t : {-7.0L, 0.4L, 5.0L, 11.5L, 200.0L}) {
      CAPTURE(e, t);
      CHECK(equation::residual(planet, t) < 1e-13L);
    }
  }
}

TEST_CASE("A planet sweeps ellipse after ellipse and keeps energy and angular momentum") {
  for (const double e : {0.0, 0.3, 0.6, 0.97}) {
    const Orbit<> planet{.eccentricity = e, .semi_major = 3, .mu = 2};
    for (int n = 0; n < 200; ++n) {
      CAPTURE(e, n);
      const auto now = planet.exact(0.61 * n);
      // The distances to the two focal points add up to the long axis.
      const Vector2d other_focus{-6 * e, 0};
      CHECK_THAT(now.x.norm() + (now.x - other_focus).norm(), WithinRel(6.0, 1e-14));
      CHECK_THAT(planet.energy(now.x, now.v), WithinRel(-2.0 / 6, 1e-12));
      CHECK_THAT(planet.angular_momentum(now.x, now.v),
                 WithinRel(std::sqrt(6 * (1 - e * e)), 1e-14));
    }
  }
}

TEST_CASE("A planet without eccentricity goes round a circle evenly") {
  const Orbit<> planet{.eccentricity = 0, .semi_major = 2, .mu = 32};
  for (const double t : {0.0, 0.3, 1.0, 2.9}) {
    CHECK((planet.exact(t).x - Vector2d(2 * std::cos(2 * t), 2 * std::sin(2 * t))).norm() < 2e-15);
    CHECK((planet.exact(t).v - Vector2d(-4 * std::sin(2 * t), 4 * std::cos(2 * t))).norm() < 4e-15);
  }
}

TEST_CASE("Kepler's third law: the period goes with the power 3/2 of the axis") {
  const Orbit<> earth{.eccentricity = 0.0167, .semi_major = 1.495978707e11, .mu = 1.32712440018e20};
  CHECK_THAT(earth.period() / 86400, WithinRel(365.2569, 1e-6));
  Orbit<> four_times = earth;
  four_times.semi_major *= 4;
  CHECK_THAT(four_times.period(), WithinRel(8 * earth.period(), 1e-15));
  const auto back = earth.exact(10 * earth.period());
  CHECK((back.x - earth.start().x).norm() / earth.semi_major < 1e-13);
}

TEST_CASE("A planet is farthest from its sun half a period after the start") {
  const Orbit<> planet{.eccentricity = 0.6};
  CHECK((planet.start().x - Vector2d(0.4, 0)).norm() < 1e-15);
  CHECK((planet.start().v - Vector2d(0, 2)).norm() < 1e-15);
  CHECK((planet.exact(planet.period() / 2).x - Vector2d(-1.6, 0)).norm() < 1e-15);
  CHECK((planet.exact(planet.period() / 2).v - Vector2d(0, -0.5)).norm() < 1e-15);
}
