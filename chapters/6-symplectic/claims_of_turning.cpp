// SPDX-License-Identifier: MIT-0
// The claims of chapter 6 about things that turn.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "measure/methods.h"
#include "measure/run.h"
#include "spin_ball.h"
#include "thrown.h"
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
  const auto keeps_its_energy = [](auto step) {
    measure::Tumbling body;
    const double thrown = body.energy();
    for (int n = 0; n < 600; ++n) {
      step(body, frame);
      CHECK_THAT(body.energy() / thrown, WithinAbs(1, 1e-3));
    }
  };
  keeps_its_energy(measure::by_midpoint);
  keeps_its_energy(measure::by_rotations);
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

TEST_CASE("Two quarter turns in the other order end a third of a turn apart") {
  using Turn = shelf::Quaternion<double>;
  const double quarter = std::numbers::pi / 2;
  const auto turned = [&](const shelf::Vec3<double>& first, const shelf::Vec3<double>& second) {
    Turn q;
    shelf::turn_exact(q, quarter * first, 1.0);
    shelf::turn_exact(q, quarter * second, 1.0);
    return q;
  };
  const Turn one = turned({1, 0, 0}, {0, 1, 0}), other = turned({0, 1, 0}, {1, 0, 0});
  const Turn between = Turn{one.w, -one.x, -one.y, -one.z} * other;
  CHECK_THAT(2 * std::acos(std::abs(between.w)), WithinAbs(2 * std::numbers::pi / 3, 1e-14));
}

TEST_CASE("The three moments of inertia of a book of 20 by 14 by 3 cm are as 1 to 2 to 2.9") {
  const auto inertia = shelf::inertia_of_box(1.0, {0.2, 0.14, 0.03});
  CHECK_THAT(inertia.y / inertia.x, WithinAbs(2, 0.05));
  CHECK_THAT(inertia.z / inertia.x, WithinAbs(2.9, 0.05));
}

TEST_CASE(
    "Rotations keep the length of the angular momentum in the body's axes to rounding, along all "
    "of a step") {
  const shelf::Vec3<double> inertia = measure::Tumbling{}.inertia;
  for (const double h : {frame, ball_step, 0.7}) {
    measure::Tumbling body;
    const double length = std::sqrt(dot(body.L, body.L));
    auto own = body.L;
    for (int n = 0; n < 60; ++n) {
      own = along_a_step(shelf::rotate_back(body.q, body.L), inertia, h, [&](int, const auto& L) {
        CHECK_THAT(std::sqrt(dot(L, L)), WithinRel(length, 1e-13));
      });
      measure::by_rotations(body, h);
      const auto off = shelf::rotate_back(body.q, body.L) + (-1.0) * own;
      CHECK(std::sqrt(dot(off, off)) < 1e-12 * length);  // these are the header's steps
    }
  }
}

TEST_CASE("The gyroscopic step of Bullet is one solve of backward Euler") {
  const Thrown body;
  auto s = body.start();
  for (int n = 0; n < 600; ++n) {
    const Eigen::Vector3d theirs = as_in_bullet(body, s.v, frame);
    measure::backward_euler(s.x, s.v, 0.0, frame, body);
    CHECK((s.v - theirs).norm() < 1e-13 * theirs.norm());
  }
}

TEST_CASE("Euler's gyroscopic torque spins a thrown body up until the numbers overflow") {
  const Thrown body;
  auto s = body.start();
  const double first = body.energy(s.v);
  double before = first;
  for (int n = 0; n < 240; ++n) {
    measure::euler(s.x, s.v, 0.0, frame, body);
    CHECK(body.energy(s.v) > (1 - 4 * std::numeric_limits<double>::epsilon()) * before);
    before = body.energy(s.v);
  }
  CHECK(before > 10 * first);
  s = measure::after(measure::euler, body, s, frame, 60);
  CHECK_FALSE(std::isfinite(body.energy(s.v)));
}

TEST_CASE("A thrown body tumbles under backward Euler and loses three tenths in a second") {
  const Thrown body;
  auto s = body.start();
  const double first = body.energy(s.v), spin = body.momentum(s.v);
  s = measure::after(measure::backward_euler, body, s, frame, 60);
  CHECK(s.v.y() < -0.8 * body.start().v.y());  // turned over
  CHECK_THAT(body.energy(s.v) / first, WithinAbs(0.70, 0.01));
  CHECK(body.momentum(s.v) < 0.9 * spin);
  const auto truth = measure::after(measure::rk4, body, body.start(), frame / 20, 1200);
  CHECK_THAT(body.energy(truth.v) / first, WithinAbs(1, 1e-6));
  CHECK(truth.v.y() < 0);
}

TEST_CASE(
    "A thrown body loses nine tenths of its loss within a sixth of a second of turning over") {
  const Thrown body;
  auto s = body.start();
  std::vector<double> energies, sides;
  measure::run(measure::backward_euler, body, s, frame, 180, [&](double, const auto& now) {
    energies.push_back(body.energy(now.v));
    sides.push_back(now.v.y());
  });
  double lost = 0, turning = 0;
  for (std::size_t n = 1; n < energies.size(); ++n) {
    const double before = sides[n < 10 ? 0 : n - 10];
    const double after = sides[std::min(n + 10, sides.size() - 1)];
    if (before * after > 0) continue;
    lost += energies[n - 1] - energies[n];
    turning += frame;
  }
  CHECK(lost > 0.9 * (energies.front() - energies.back()));
  CHECK(turning < 1.1);  // of three seconds
}

TEST_CASE(
    "A thrown body first turns over after 0.52 s under backward Euler, and the true one after "
    "0.55") {
  CHECK_THAT(first_flip_time(measure::backward_euler, 1), WithinAbs(0.517, 0.001));
  for (const int parts : {10, 40}) {
    CHECK_THAT(first_flip_time(measure::midpoint, 10 * parts), WithinAbs(0.55, 0.001));
  }
}

TEST_CASE("In ten seconds RK4 takes less than a hundredth of a per cent from a thrown body") {
  const Thrown body;
  const auto start = body.start();
  const auto s = measure::after(measure::rk4, body, start, frame, 600);
  CHECK(body.energy(s.v) < body.energy(start.v));
  CHECK(body.energy(s.v) > 0.9999 * body.energy(start.v));
  const auto lost = measure::after(measure::backward_euler, body, start, frame, 600);
  CHECK_THAT(body.energy(lost.v) / body.energy(start.v), WithinAbs(0.115, 0.005));
}

TEST_CASE("The trapezoid rule keeps a thrown body's energy within one per cent") {
  const Thrown body;
  auto s = body.start();
  const double first = body.energy(s.v);
  for (int n = 0; n < 600; ++n) {
    measure::trapezoid(s.x, s.v, 0.0, frame, body);
    CHECK_THAT(body.energy(s.v) / first, WithinAbs(1, 0.01));
  }
}
