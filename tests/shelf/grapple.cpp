// SPDX-License-Identifier: MIT-0
#include "shelf/grapple.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>

#include "frames/recorded.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using Eigen::Vector3d;

namespace {

const auto dot = [](const auto& p, const auto& q) { return p.dot(q); };
const Vector3d gravity(0, 0, -9.81), still(0, 0, 0);

// A player who swings without gravity: what he does is known.
struct Weightless {
  Vector3d x{5, 0, 0}, v{0, 3, 4};
  double length = 5;

  double step(double reel, double h) {
    return shelf::grapple_step(x, v, length, still, still, reel, still, h, dot);
  }
};

}  // namespace

TEST_CASE("Without gravity he circles at one speed, in one plane, and the pull is v^2 / r") {
  for (const double h : {1e-3, 1 / 60.0, 1 / 15.0}) {
    Weightless player;
    for (int n = 0; n < 500; ++n) {
      const double pull = player.step(0, h);
      REQUIRE_THAT(player.x.norm(), WithinRel(5.0, 1e-14));
      REQUIRE_THAT(player.v.norm(), WithinRel(5.0, 1e-12));
      REQUIRE_THAT(player.x.dot(player.v), WithinAbs(0, 1e-12));
      REQUIRE_THAT(player.x.dot(Vector3d(0, 4, -3)), WithinAbs(0, 1e-12));
      REQUIRE_THAT(pull, WithinRel(5.0, 0.06));
    }
  }
}

TEST_CASE("Reeled in, he keeps his angular momentum, and is faster the shorter the rope") {
  Weightless player;
  for (int n = 0; n < 240; ++n) player.step(-1, 1 / 60.0);
  CHECK_THAT(player.length, WithinRel(1.0, 1e-12));
  CHECK_THAT(player.x.cross(player.v).norm(), WithinRel(25.0, 0.02));
  CHECK_THAT(player.x.dot(player.v) / player.length, WithinRel(-1.0, 1e-9));
}

TEMPLATE_TEST_CASE("While the rope is slack he flies as if there were none", "", float, double) {
  using Vec = Eigen::Matrix<TestType, 3, 1>;
  Vec x(1, 0, 2), v(1, 2, 3);
  const Vec a(0, 0, TestType(-9.81)), hook(0, 0, 3);
  TestType length = 40;
  for (int n = 0; n < 30; ++n) {
    CHECK(shelf::grapple_step(x, v, length, hook, Vec(0, 0, 0), TestType(0.5), a, TestType(1) / 60,
                              dot) == 0);
  }
  CHECK((x - Vec(TestType(1.5), 1, TestType(2 + 1.5 - 9.81 / 8))).norm() < TestType(1e-4));
  CHECK((v - Vec(1, 2, TestType(3 - 9.81 / 2))).norm() < TestType(1e-4));
  CHECK_THAT(double(length), WithinRel(40.25, 1e-5));
}

TEST_CASE("A rope that comes taut takes the speed along it, and only that") {
  Vector3d x(0, 3, 0), v(2, 30, 0);
  double length = 5;
  for (int n = 0; n < 12; ++n) {
    shelf::grapple_step(x, v, length, still, still, 0, still, 1 / 60.0, dot);
  }
  CHECK_THAT(x.norm(), WithinRel(5.0, 1e-12));
  // Taut after 1/15 s, two fifteenths aside: what is left is the speed across the rope there.
  CHECK_THAT(v.norm(), WithinRel(2 - 30 * (2 / 15.0) / 5, 0.01));
  CHECK_THAT(x.dot(v), WithinAbs(0, 1e-12));
}

TEST_CASE("In frames of any length a swing of a minute keeps its energy to a thousandth") {
  frames::Playback frame;
  Vector3d x(3, 0, -4), v(0, 1, 0);
  double length = 5;
  const double first = v.squaredNorm() / 2 + 9.81 * (x.z() + 5);
  for (int n = 0; n < 3600; ++n) {
    shelf::grapple_step(x, v, length, still, still, 0, gravity, frame.next(), dot);
    REQUIRE_THAT(v.squaredNorm() / 2 + 9.81 * (x.z() + 5), WithinRel(first, 1e-2));
  }
}

TEST_CASE("A hook that moves evenly is one that rests, for who moves along") {
  const Vector3d moves(3, -1, 2);
  Vector3d x(3, 0, -4), v(0, 1, 0), y = x, w = v + moves;
  double length = 5, other = 5;
  for (int n = 1; n <= 300; ++n) {
    shelf::grapple_step(x, v, length, still, still, -0.3, gravity, 1 / 60.0, dot);
    shelf::grapple_step(y, w, other, Vector3d(n / 60.0 * moves), moves, -0.3, gravity, 1 / 60.0,
                        dot);
    REQUIRE((y - n / 60.0 * moves - x).norm() < 1e-10);
    REQUIRE((w - moves - v).norm() < 1e-10);
  }
}

TEST_CASE("A rope of no length holds him at the hook, and a reel stops there") {
  Vector3d x(0, 1, 0), v(1, 0, 0);
  double length = 0.1;
  for (int n = 0; n < 10; ++n) {
    shelf::grapple_step(x, v, length, still, still, -1, gravity, 1 / 15.0, dot);
  }
  CHECK(length == 0);
  CHECK(x == still);
  CHECK((v.array().isFinite()).all());
}

TEST_CASE("What is thrown over the hook in one step comes back onto the circle") {
  Vector3d x(5, 0, 0), v(-6000, 10, 0);
  double length = 5;
  shelf::grapple_step(x, v, length, still, still, 0, gravity, 1 / 60.0, dot);
  CHECK_THAT(x.norm(), WithinRel(5.0, 1e-12));
  CHECK(x.x() < 0);
}

TEST_CASE("What is not a number stays none, and stops nothing") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Vector3d x(5, 0, 0), v(0, 3, 0);
  double length = 5;
  shelf::grapple_step(x, v, length, still, still, 0, Vector3d(nan, 0, 0), 1 / 60.0, dot);
  CHECK(std::isnan(x.x()));
}
