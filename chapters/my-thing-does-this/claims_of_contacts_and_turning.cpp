// SPDX-License-Identifier: MIT-0
// What the page says of what touches, turns and runs for long.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstddef>

#include "held.h"
#include "sketch.h"

TEST_CASE(
    "Turned round wherever it is below the floor, a ball sinks 25 cm into it in three seconds, and "
    "by bounce_step it lies on it") {
  const Sketch s = sketch("trembles");
  rounds(s.ill().last(), -0.25, 0.01);
  CHECK(s.mended().least() >= 0);
  CHECK(s.mended().last() == 0);
}

TEST_CASE(
    "Put back onto the floor a ball keeps 6 cm/s for ever, and by bounce_step it is at rest to the "
    "bit") {
  const Sketch s = sketch("never-rests");
  rounds(s.ill().last(), 0.06, 0.01);
  CHECK(s.ill().sway(30) < 1e-6);
  CHECK(s.mended().last() == 0);
  CHECK(s.mended().sway(30) == 0);
}

TEST_CASE(
    "Place first, a ball without loss that fell 1 m bounces 1.9 m high within eight seconds, and "
    "by bounce_step never higher than 1") {
  const Sketch s = sketch("bounces-higher");
  rounds(s.ill().most(), 1.9, 0.1);
  CHECK(s.mended().most() <= 1);
}

TEST_CASE(
    "On a spring of 100 N/m a kilogram stands 9.8 cm deep in the floor, and by bounce_step on it") {
  const Sketch s = sketch("sinks");
  rounds(s.ill().last(), -0.098, 0.001);
  CHECK(s.mended().last() == 0);
}

TEST_CASE(
    "Sixty metres a second fly through a wall of 20 cm at 60 Hz, and bounce_step lets nothing "
    "through") {
  const Sketch s = sketch("goes-through");
  CHECK(s.ill().last() > 11);
  CHECK(s.mended().most() <= 3.3);
}

TEST_CASE(
    "On a slope of 20 degrees a brake of 20 1/s lets a crate creep 66 cm in four seconds, and "
    "friction of 0.5 holds it to the bit") {
  const Sketch s = sketch("creeps");
  rounds(s.ill().last(), 0.66, 0.01);
  CHECK(s.mended().most() == 0);
}

TEST_CASE(
    "On a platform that swings by 2 m at 2 rad/s a player falls up to 75 cm behind, and on a "
    "MovingPlane he stands") {
  const Sketch s = sketch("leaves-the-platform");
  rounds(s.ill().most(), 0.75, 0.01);
  CHECK(s.mended().most() == 0);
}

TEST_CASE(
    "At 15 Hz a corner of a car with dampers of 30 kN s/m is thrown 4.6 m up, and by wheel_push it "
    "stands") {
  const Sketch s = sketch("car-shakes");
  rounds(s.ill().most(), 4.6, 0.1);
  CHECK(s.mended().most() <= 0.1);
  CHECK(s.mended().sway(20) < 0.01);
}

TEST_CASE(
    "With each corner for itself a crate still rocks after three seconds, and by contact_step it "
    "lies still") {
  const Sketch s = sketch("never-settles");
  CHECK(s.ill().sway(30) > 0.01);
  CHECK(std::abs(s.mended().last()) < 1e-12);
  CHECK(s.mended().sway(30) < 1e-12);
}

TEST_CASE(
    "By q += h/2 w q a thing that turns at 6 rad/s is 2.1 times as large after five seconds, and "
    "by turn_exact as large as it was") {
  const Sketch s = sketch("grows");
  rounds(s.ill().last(), 2.1, 0.1);
  rounds(s.mended().last(), 1, 1e-12);
}

TEST_CASE(
    "By the spin of the start a body with moments 1, 2 and 3 has twice its energy after ten "
    "seconds, and by spin_by_rotations it keeps it within 0.1 %") {
  const Sketch s = sketch("spins-faster");
  rounds(s.ill().last(), 2, 0.01);
  CHECK(s.mended().most() < 1.0012);
  CHECK(s.mended().least() > 0.999);
}

TEST_CASE("Smoothed as a number, an angle goes 340 degrees back, and turn_damp goes the other 20") {
  const Sketch s = sketch("long-way-round");
  rounds(s.ill().most(), 340, 1e-9);
  CHECK(s.ill().last() < 1);
  rounds(s.mended().most(), 20, 1e-9);
  CHECK(std::abs(s.mended().last()) < 0.1);
}

TEST_CASE(
    "By Euler's method a moon that is stepped 120 times a turn is three radii out after ten turns, "
    "and by leapfrog within 0.2 % of one") {
  const Sketch s = sketch("spirals-out");
  rounds(s.ill().last(), 3.03, 0.01);
  CHECK(s.mended().most() < 1.002);
  CHECK(s.mended().least() > 0.998);
}

TEST_CASE(
    "With twenty steps a turn RK4 brings a moon down to 0.6 radii in 200 turns, and leapfrog keeps "
    "it within 5 %") {
  const Sketch s = sketch("sinks-into-the-planet");
  rounds(s.ill().last(), 0.6, 0.1);
  CHECK(s.ill().last() == s.ill().least());
  CHECK(s.mended().most() < 1.05);
  CHECK(s.mended().least() > 0.95);
}

TEST_CASE(
    "In recorded frames a spring of 20 rad/s swings more than five times as far within a minute, "
    "and in even steps at most 1.1 times") {
  const Sketch s = sketch("swings-higher-in-frames");
  CHECK(s.ill().most() > 5);
  CHECK(s.mended().most() < 1.1);
}

TEST_CASE(
    "A door of 20 cm/s moves by nothing in float at 100 km, and by 20 cm counted from a place "
    "nearby") {
  const Sketch s = sketch("stands-still");
  CHECK(s.ill().last() == 0);
  rounds(s.mended().last(), 0.2, 1e-6);
}

TEST_CASE(
    "Stepped by their frames, two machines disagree on a pendulum by radians within six seconds, "
    "and stepped evenly by nothing") {
  const Sketch s = sketch("other-replay");
  CHECK(std::abs(s.ill().last()) > 1);
  CHECK(s.mended().sway(points) == 0);
  CHECK(s.mended().last() == 0);
}
