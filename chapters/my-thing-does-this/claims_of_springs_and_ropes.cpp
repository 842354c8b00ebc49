// SPDX-License-Identifier: MIT-0
// What the page says of springs, cameras and ropes.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <complex>
#include <cstddef>

#include "held.h"
#include "measure/sheet.h"
#include "shelf/link.h"
#include "shelf/smooth_damp.h"
#include "sketch.h"

using Catch::Matchers::WithinRel;

TEST_CASE(
    "By Euler's method a spring of 6 rad/s swings 2.9 m after four seconds instead of one, and "
    "velocity first at most 1.001") {
  const Sketch s = sketch("swings-higher");
  rounds(std::max(-s.ill().least(), s.ill().most()), 2.99, 0.01);
  CHECK(s.mended().most() <= 1.0015);
  CHECK(s.mended().least() >= -1.0015);
}

TEST_CASE(
    "By backward Euler a spring of 6 rad/s has a sixth of its swing after six seconds, and "
    "velocity first all of it") {
  const Sketch s = sketch("swing-dies");
  CHECK(std::abs(s.ill().sway(20) / 2 - 1 / 6.0) < 0.05);
  CHECK(s.mended().sway(30) / 2 > 0.99);
}

TEST_CASE(
    "With c h = 1.95 an explicit damper turns the speed round in each step and leaves a fifth of "
    "it after half a second; divided, it is gone") {
  const Sketch s = sketch("buzzes");
  CHECK(s.ill().least() < -0.9);
  rounds(s.ill().last(), 0.21, 0.01);
  CHECK(s.mended().last() < 1e-9);
  CHECK(s.mended().least() >= 0);
}

TEST_CASE(
    "A critically damped camera that comes in with 60 m/s overshoots its 3 m by 3.4 m, and without "
    "overshoot by nothing") {
  const Sketch s = sketch("overshoots");
  rounds(s.ill().most() - 3, 3.4, 0.1);
  CHECK(s.mended().most() <= 3);
}

TEST_CASE(
    "With omega = 4 a camera trails a runner of 10 m/s by 4.9 m, and if it is told his velocity it "
    "catches up") {
  const Sketch s = sketch("lags");
  rounds(s.ill().last(), 4.9, 0.1);
  CHECK(s.mended().last() < 1e-3);
}

TEST_CASE(
    "Behind a runner of 10 m/s who stops dead a camera that has kept up passes him by v over e "
    "omega, and one that trails by 2 v over omega does not") {
  constexpr double omega = 4, speed = 10;
  for (const double behind : {0.0, 2 * speed / omega}) {
    double x = -behind, v = speed, furthest = 0;
    for (int n = 0; n < 600; ++n) {
      shelf::smooth_damp(x, v, 0.0, 0.0, omega, 1 / 240.0);
      furthest = std::max(furthest, x);
    }
    CHECK(std::abs(furthest - (behind > 0 ? 0 : speed / (std::exp(1.0) * omega))) < 1e-3);
  }
}

TEST_CASE(
    "After a jump of 80 m a camera with omega = 4 goes 118 m/s, and with a top speed of 40 no more "
    "than that") {
  const Sketch s = sketch("whips");
  rounds(s.ill().most(), 118, 1);
  CHECK(s.mended().most() <= 40);
}

TEST_CASE(
    "A soft constraint of 5 Hz without damping has less than a thousandth of its swing after a "
    "second at 60 Hz") {
  const Sketch s = sketch("too-soft");
  CHECK(std::abs(s.ill().last()) < 1e-4);
  CHECK(s.ill().sway(12) / 2 < 1e-4);
  rounds(s.mended().last(), 0.1, 1e-9);
}

TEST_CASE(
    "Over a kerb between two steps RK4 is off by 0.7 mm at 60 Hz, and if it stops there and goes "
    "on, by a thousandth of a millimetre") {
  const Sketch s = sketch("no-better");
  rounds(s.ill().most(), 0.7, 0.01);
  CHECK(s.mended().most() < 1.3e-3);
}

TEST_CASE(
    "In its first two seconds a rope of two metres gets up to 3.9 m long with one pass a frame, "
    "and 2.03 with eight substeps") {
  const Sketch s = sketch("sags");
  rounds(s.ill().most(), 3.9, 0.1);
  rounds(s.mended().most(), 2.03, 0.01);
}

namespace {

// A rope of ten metres between two hooks ten metres apart, from the thirtieth second to the
// sixtieth.
struct Taut {
  double sag = 0, stretch = 0;

  explicit Taut(int substeps) {
    using Flat = std::complex<double>;
    constexpr int count = 51, frames = 60 * 60;
    Flat x[count], before[count];
    double tension[count - 1] = {}, w[count];
    for (int i = 0; i < count; ++i) x[i] = before[i] = 0.2 * i, w[i] = 1 / 0.01;
    w[0] = w[count - 1] = 0;
    const shelf::Rope<double> links{0.2};
    for (int n = 0; n < frames; ++n) {
      for (int i = 0; i < substeps; ++i) {
        shelf::rope_step(
            x, before, tension, w, count, links, Flat(0, -9.81), 1 / 60.0 / substeps,
            [](Flat d) { return std::abs(d); }, [](Flat place) { return place; });
      }
      if (n < frames / 2) continue;
      double length = 0;
      for (int i = 1; i < count; ++i) length += std::abs(x[i] - x[i - 1]);
      sag -= x[count / 2].imag() / (frames / 2);
      stretch += (length / 10 - 1) / (frames / 2);
    }
  }
};

}  // namespace

TEST_CASE(
    "Ten metres of rope between hooks ten metres apart sag by 0.8 m in eight substeps, for a "
    "stretch under 2 %, and by 0.3 m in thirty-two") {
  const Taut eight(8);
  rounds(eight.sag, 0.8, 0.1);
  CHECK(eight.stretch < 0.02);
  CHECK_THAT(eight.sag, WithinRel(10 * std::sqrt(3 * eight.stretch / 8), 0.03));
  CHECK_THAT(0.06, WithinRel(std::sqrt(3 * 0.01 / 8), 0.05));
  rounds(Taut(32).sag, 0.3, 0.1);
}

TEST_CASE(
    "With one pass a frame the rope gets 9.6 m long at 30 fps in two seconds, and 2.5 at 120; in "
    "substeps of 1/480 s it gets 2.03 at 30 as well") {
  const Sketch s = sketch("softer-by-frames");
  rounds(s.ill().most(), 9.6, 0.1);
  rounds(s.ill(1).most(), 2.5, 0.1);
  rounds(s.mended().most(), 2.03, 0.01);
}

TEST_CASE(
    "Two bodies of 10 g on 1000 N/m explode at 60 Hz velocity first, and by a link they come to "
    "rest") {
  const Sketch s = sketch("stiff-explodes");
  wild(s.ill(), 1e6);
  CHECK(s.mended().sway(30) == 0);
}

TEST_CASE(
    "A level sheet of 64 by 32 cells in free fall has links of twice their length in its third "
    "frame if they are taken cell by cell, and shuffled none is off by two thousandths of a per "
    "cent") {
  const Sketch s = sketch("cloth-bursts");
  CHECK(s.ill().values[12] > 100);  // 3 of 30 frames
  CHECK(s.mended().most() < 2e-3);
}

TEST_CASE(
    "A sheet whose links are gone through there and back in turn bursts all the same, and one "
    "whose links are gone through twice in each substep keeps its shape") {
  measure::Sheet turned, twice;
  double most = 0;
  for (int n = 0; n < 30 * 16; ++n) {
    turned.step(1 / 960.0f, 1e-5f, 1), turned.turn_round();
    twice.step(1 / 960.0f, 1e-5f, 2);
    most = std::max(most, twice.worst());
  }
  CHECK(turned.worst() > 1);
  CHECK(most < 2e-5);
}

TEST_CASE(
    "Let go at 1 rad, a swing on one link of 6 m goes to 0.79 rad in seconds 10 to 15, and by "
    "grapple_step to 1") {
  const Sketch s = sketch("loses-its-swing");
  rounds(s.ill().sway(40) / 2, 0.79, 0.01);
  rounds(s.mended().sway(40) / 2, 1, 0.01);
}

TEST_CASE(
    "In recorded frames a Verlet jump of 9 m/s is 4.1 m off after 1.8 s, and with the two lengths "
    "none") {
  const Sketch s = sketch("verlet-in-uneven-frames");
  rounds(s.ill().last(), -4.1, 0.1);
  CHECK(std::abs(s.mended().last()) < 1e-9);
}
