// SPDX-License-Identifier: MIT-0
// What the page says of frames, and of what jumps, falls and is thrown.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstddef>

#include "held.h"
#include "sketch.h"

TEST_CASE(
    "Velocity first, a spring of 6 Hz explodes at 15 frames a second, and by the exact step it "
    "swings on") {
  const Sketch s = sketch("explodes");
  wild(s.ill(), 1e6);
  CHECK(s.mended().most() <= 1 + 1e-12);
  CHECK(s.mended().last() > 0.99);
}

TEST_CASE("Place first, a jump of 4 m goes 4.63 m high at 15 fps and 4.15 at 60") {
  const Sketch s = sketch("jumps-higher");
  rounds(s.ill().most(), 4.63, 0.01);
  rounds(s.ill(1).most(), 4.15, 0.01);
  CHECK(s.mended().most() <= 4);
  CHECK(s.mended().most() > 3.9);
}

TEST_CASE(
    "Kept by 0.99 in each frame, 10 m/s are 5.5 after two seconds at 30 fps, and 0.55 at 144") {
  const Sketch s = sketch("brakes-by-frames");
  rounds(s.ill().last(), 5.5, 0.1);
  rounds(s.ill(1).last(), 0.55, 0.01);
  rounds(s.mended().last(), 10 * std::pow(0.99, 120), 1e-9);
}

TEST_CASE(
    "By a tenth of the way in each frame a camera is there to three micrometres at 144 fps, and to "
    "42 "
    "cm at 30") {
  const Sketch s = sketch("smooths-by-frames");
  rounds(10 - s.ill().last(), 0.42, 0.01);
  CHECK(10 - s.ill(1).last() < 3e-6);
  rounds(s.mended().last(), 10 - 10 * std::pow(0.9, 60), 1e-9);
}

TEST_CASE(
    "Behind a runner of 10 m/s who is stepped at 60 Hz a camera at 75 fps sees him sway by 13 cm, "
    "and blended by nothing") {
  const Sketch s = sketch("jitters");
  rounds(s.ill().sway(46), 13, 1);
  CHECK(s.mended().sway(46) < 1e-9);
}

TEST_CASE(
    "At 30 ticks and 144 frames a second a thing moves by 20 cm in one frame of five and by none "
    "in the others, and blended by 4.2 cm in each") {
  const Sketch s = sketch("stutters");
  rounds(s.ill().most(), 20, 1e-9);
  CHECK(s.ill().least() == 0);
  CHECK(std::abs(std::count(s.ill().values.begin(), s.ill().values.end(), 0.0) - 39) <= 1);
  rounds(s.mended().most(), 4.17, 0.01);
  CHECK(s.mended().sway(49) < 1e-9);
}

TEST_CASE(
    "With a quarter of the step a jump of 4 m is 11 cm higher; with a quarter of the frame it is "
    "the same") {
  const Sketch s = sketch("slow-motion");
  rounds(s.ill().most() - s.ill(1).most(), 0.11, 0.01);
  rounds(s.ill(1).most(), 4, 0.1);
  CHECK(s.mended().most() == s.ill(1).most());
}

TEST_CASE(
    "A ball that stops at a wall flies through it in a frame of half a second, and with a longest "
    "frame it does not") {
  const Sketch s = sketch("hitch");
  CHECK(s.ill().last() > 20);
  CHECK(s.mended().most() == 5);
  CHECK(s.mended().last() == 5);
}

TEST_CASE(
    "After a day two frames in a row are 15.6 or 23.4 ms apart in float, and 16.67 by FixedStep") {
  const Sketch s = sketch("a-day");
  rounds(s.ill().least(), 15.6, 0.1);
  rounds(s.ill().most(), 23.4, 0.1);
  CHECK(s.mended().sway(31) < 1e-6);
  rounds(s.mended().last(), 16.67, 0.01);
}

TEST_CASE(
    "If a step of 16.7 ms takes 18, frames grow without end, with a longest frame of a quarter of "
    "a second to 278 ms, and of 1/15 s to 80") {
  const Sketch s = sketch("spiral");
  CHECK(s.ill().last() > 2000);
  CHECK(s.ill().last() == s.ill().most());
  rounds(s.ill(1).most(), 278, 1e-6);
  rounds(s.mended().most(), 80, 1e-9);
  CHECK(s.mended().sway(30) < 1e-9);
}

TEST_CASE("Velocity first, a jump of 4 m goes 3.42 m high at 15 Hz, and by jump_step 4") {
  const Sketch s = sketch("too-low");
  rounds(s.ill().most(), 3.42, 0.01);
  CHECK(s.mended().most() > 3.96);
}

TEST_CASE(
    "After two seconds at 60 Hz a fall is 16.3 cm too far velocity first, and 4.1 cm in four "
    "substeps") {
  const Sketch s = sketch("falls-otherwise");
  rounds(s.ill().last(), 16.3, 0.1);
  rounds(s.ill(1).last(), 4.1, 0.1);
  CHECK(std::abs(s.mended().last()) < 1e-9);
}

TEST_CASE(
    "Braked before the force at 15 Hz, what should fall at 2 m/s falls at 2.65, and braked after "
    "it at 2") {
  const Sketch s = sketch("terminal-speed");
  rounds(s.ill().last(), 2.65, 0.01);
  rounds(s.mended().last(), 2, 0.01);
  CHECK(s.mended().most() <= 2);
}

TEST_CASE(
    "In water at 60 Hz a bullet of 350 m/s is thrown back at once by explicit drag, and by "
    "quadratic_drag it only slows down") {
  const Sketch s = sketch("backwards");
  CHECK(s.ill().values[20] < -1000);
  wild(s.ill(), 1e6);
  CHECK(s.mended().least() > 0);
  CHECK(s.mended().last() == s.mended().least());
}

TEST_CASE(
    "A grenade with drag of 0.3 1/s flies 2.7 m below its parabola, and on the arc of its own step "
    "to the bit") {
  const Sketch s = sketch("wrong-arc");
  rounds(s.ill().most() - s.ill(1).most(), 2.7, 0.1);
  CHECK(s.mended().values == s.ill(1).values);
}

TEST_CASE(
    "Aimed at where a truck of 15 m/s is, a shell passes 5.4 m away, and aimed where it will be it "
    "hits") {
  const Sketch s = sketch("misses");
  rounds(s.ill().least(), 5.4, 0.1);
  CHECK(s.mended().least() < 0.05);
}

TEST_CASE(
    "With thrust towards its target a missile never comes nearer than 22 m, and with thrust "
    "towards the velocity that it wants it hits") {
  const Sketch s = sketch("orbits");
  rounds(s.ill().least(), 22, 0.1);
  CHECK(s.mended().last() < 1);
}
