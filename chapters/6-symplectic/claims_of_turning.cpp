// SPDX-License-Identifier: MIT-0
// The claims of chapter 6 about things that turn.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "tumbling.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE(
    "Turned by its spin at the start of each step a thrown body has twice its energy after ten "
    "seconds") {
  CHECK_THAT(energy_after_ten_seconds(measure::by_its_spin), WithinRel(2, 0.01));
  // All of it is in the axis of the smallest moment, and none can be added.
  measure::Tumbling body;
  for (int n = 0; n < 600; ++n) measure::by_its_spin(body, frame);
  const auto own = shelf::rotate_back(body.q, body.L);
  CHECK(std::abs(own.x) > 0.999 * std::sqrt(dot(body.L, body.L)));
}

TEST_CASE("Bullet's gyroscopic step takes 88 per cent of a thrown body's energy in ten seconds") {
  CHECK_THAT(energy_after_ten_seconds(measure::by_bullet), WithinAbs(0.12, 0.01));
}

TEST_CASE(
    "Under Jolt's gyroscopic step a body ends up tumbling about its middle axis, whichever axis it "
    "was thrown about") {
  for (int axis = 0; axis < 3; ++axis) {
    scenes::EulerTop top;
    top.w = {2, 2, 2};
    top.w(axis) = 20;
    measure::Tumbling body(top), truth(top);
    const double L = dot(body.L, body.L), least_moment = body.inertia.x;
    const double about_the_middle = L / (2 * body.inertia.y);
    // At first it has the energy of the axis that it was thrown about.
    if (axis != 1) CHECK(std::abs(body.energy() / about_the_middle - 1) > 0.3);
    CHECK(body.energy() < L / (2 * least_moment));
    for (int n = 0; n < 1800; ++n)
      measure::by_jolt(body, frame), measure::by_rotations(truth, frame);
    CAPTURE(axis);
    CHECK_THAT(body.energy(), WithinRel(about_the_middle, 1e-3));
    CHECK_THAT(truth.energy(), WithinRel(measure::Tumbling(top).energy(), 1e-2));
  }
}

TEST_CASE(
    "In ten seconds Jolt's gyroscopic step keeps the length of L and turns its direction by more "
    "than ten degrees") {
  measure::Tumbling body;
  const auto thrown = body.L;
  for (int n = 0; n < 600; ++n) measure::by_jolt(body, frame);
  const double length = std::sqrt(dot(body.L, body.L) * dot(thrown, thrown));
  CHECK_THAT(dot(body.L, body.L), WithinRel(dot(thrown, thrown), 1e-11));
  CHECK(dot(body.L, thrown) / length < std::cos(10 * std::numbers::pi / 180));
  CHECK_THAT(energy_after_ten_seconds(measure::by_jolt), WithinRel(1, 1e-3));
}

TEST_CASE(
    "Rotations turn a thrown body ten times nearer than the midpoint rule, and both keep its "
    "energy to a thousandth") {
  CHECK(measure::off_in_a_second(measure::by_midpoint) >
        10 * measure::off_in_a_second(measure::by_rotations));
  CHECK_THAT(energy_after_ten_seconds(measure::by_midpoint), WithinRel(1, 1e-3));
  CHECK_THAT(energy_after_ten_seconds(measure::by_rotations), WithinRel(1, 1e-3));
}

TEST_CASE("Turned exactly by its own spin the midpoint rule is off by less than a fifth as much") {
  shelf::Vec3<double> own = measure::Tumbling().L;  // in the body's axes, where the rule steps it
  const auto exactly = [&own](auto& body, double h) {
    const shelf::SpinEquation<double> to_middle{own, body.inertia, h / 2};
    auto middle = own;
    for (int n = 0; n < 6; ++n) middle = to_middle.better(middle);
    own = 2.0 * middle + (-1.0) * own;
    const auto& [x, y, z] = body.inertia;
    shelf::turn_exact(body.q, shelf::rotate(body.q, {middle.x / x, middle.y / y, middle.z / z}), h);
  };
  const double off = measure::off_in_a_second(exactly);
  CHECK(off < measure::off_in_a_second(measure::by_midpoint) / 5);
  CHECK(off > measure::off_in_a_second(measure::by_rotations));
}

TEST_CASE(
    "In ten seconds a crate turned by its spin has twice its energy, by Bullet's step a third") {
  double naive_at_end = 0, bullet_at_end = 0;
  throw_a_crate([&](double, double naive, double bullet, double) {
    naive_at_end = naive;
    bullet_at_end = bullet;
  });
  CHECK_THAT(naive_at_end, WithinAbs(2, 0.02));
  CHECK_THAT(bullet_at_end, WithinAbs(1.0 / 3, 0.02));
}

TEST_CASE("Rotations keep the energy of a thrown crate to a thousandth") {
  throw_a_crate(
      [](double, double, double, double rotations) { CHECK_THAT(rotations, WithinAbs(1, 0.001)); });
}
