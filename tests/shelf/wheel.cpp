// SPDX-License-Identifier: MIT-0
#include "shelf/wheel.h"

#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>

#include "frames/recorded.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double g = 9.81;

// A plank of 100 kg and of length 2 b on two wheels, in the plane, as high as its springs are long.
template <class Real>
struct Plank {
  Real mass = 100, moment = 30, b = 1;
  Real y = Real(0.5), turned = 0, rises = 0, spin = 0;
  Real force[2] = {0, 0};
  bool warm = true;
  int passes = 1;
  Real felt = 1 / mass + b * b / moment;

  void push(int side, Real by) {
    rises += by / mass;
    spin += Real(side == 0 ? -1 : 1) * b * by / moment;
  }

  void step(Real h, Real stiffness, Real damping) {
    rises -= h * Real(g);
    for (int i = 0; i < 2; ++i) {
      if (!warm) force[i] = 0;
      push(i, h * force[i]);
    }
    for (int visit = 0; visit < 2 * passes; ++visit) {
      const int i = visit % 2;
      const Real arm = Real(i == 0 ? -1 : 1) * b;
      push(i, shelf::wheel_push(force[i], Real(0.4) - (y + arm * turned), rises + arm * spin, felt,
                                shelf::Suspension<Real>{stiffness, damping}, h));
    }
    y += h * rises;
    turned += h * spin;
  }

  double height() const { return double(y); }
};

}  // namespace

TEMPLATE_TEST_CASE("On two wheels a plank comes to rest where its springs carry it", "", float,
                   double) {
  for (const int rate : {15, 60, 240}) {
    for (const double damping : {1e3, 1e4}) {
      CAPTURE(rate, damping);
      Plank<TestType> plank;
      plank.turned = TestType(0.1);
      for (int n = 0; n < 60 * rate; ++n) {
        plank.step(1 / TestType(rate), TestType(1e4), TestType(damping));
      }
      const double tolerance = 1e4 * double(std::numeric_limits<TestType>::epsilon());
      CHECK_THAT(plank.height(), WithinAbs(0.4 - 100 * g / 2e4, tolerance));
      CHECK_THAT(double(plank.turned), WithinAbs(0, tolerance));
    }
  }
}

TEST_CASE("A wheel that is handed nothing on stands aslant after one pass, and not after twenty") {
  const auto stands = [](bool warm, double tilt) {
    Plank<double> plank;
    plank.warm = warm, plank.turned = tilt;
    for (int n = 0; n < 6000; ++n) plank.step(1 / 60.0, 1e4, 1e4);
    return std::abs(plank.turned);
  };
  CHECK(stands(true, 0.1) < 1e-9);
  CHECK(stands(false, 0.1) > 1e-3);
}

TEST_CASE("With the mass of the whole for that of one wheel, strong dampers throw it") {
  Plank<double> plank;
  plank.moment = 5, plank.felt = 1 / plank.mass;
  double highest = 0;
  for (int n = 0; n < 600; ++n) {
    plank.step(1 / 60.0, 1e4, 1e5);
    highest = std::max(highest, std::abs(plank.turned));
    if (highest > 10) break;
    if (n == 60) plank.spin += 0.01;
  }
  CHECK(highest > 10);
}

TEST_CASE("In the air a wheel carries nothing, and gives back what was handed on") {
  for (const double compression : {0.0, -0.2}) {
    double force = 700;
    CHECK(shelf::wheel_push(force, compression, -3.0, 0.01, {1e4, 1e3}, 0.02) == -0.02 * 700);
    CHECK(force == 0);
  }
  double force = 700;  // pulled apart faster than the spring pushes
  CHECK(shelf::wheel_push(force, 0.01, 30.0, 0.01, {1e4, 1e3}, 0.02) == -0.02 * 700);
  CHECK(force == 0);
}

TEST_CASE("Frames of any length stand as well, since a force is handed on and no push") {
  frames::Playback frame;
  Plank<double> plank;
  for (int n = 0; n < 3000; ++n) plank.step(frame.next(), 1e4, 3e3);
  CHECK_THAT(plank.height(), WithinAbs(0.4 - 100 * g / 2e4, 1e-9));
}

TEST_CASE("Halved steps halve how far it is off") {
  const auto height = [](int rate) {
    Plank<double> plank;
    plank.y = 0.37;  // on its springs all the time
    for (int n = 0; n < rate; ++n) plank.step(1.0 / rate, 1e4, 1e3);
    return plank.height();
  };
  const double ratio = (height(4096) - height(8192)) / (height(8192) - height(16384));
  CHECK_THAT(std::log2(ratio), WithinAbs(1, 0.1));
}

TEST_CASE(
    "Without a spring and a damper nothing is pushed, and nothing is learned from no number") {
  double force = 0;
  CHECK(shelf::wheel_push(force, 0.1, -3.0, 0.01, {0.0, 0.0}, 0.02) == 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  force = 300;
  shelf::wheel_push(force, nan, -3.0, 0.01, {1e4, 1e3}, 0.02);
  CHECK(force == 0);
}

TEST_CASE("Stiff springs stand, too, in long steps, after eight passes and not after one") {
  const auto restless = [](int passes) {
    Plank<double> plank;
    plank.passes = passes, plank.turned = 0.01;
    double most = 0;
    for (int n = 0; n < 15 * 60; ++n) {
      plank.step(1 / 15.0, 1e5, 1e3);
      if (n > 15 * 50) most = std::max(most, std::abs(plank.height() - (0.4 - 100 * g / 2e5)));
    }
    return most;
  };
  CHECK(restless(8) < 1e-9);
  CHECK(restless(1) > 1e-3);
}

TEST_CASE("A tyre holds what it can, and slides with what is left") {
  double force = 0, v = 2;
  v += shelf::wheel_grip(force, v, 0.01, 300.0, 0.1) / 100;
  CHECK_THAT(v, WithinAbs(2 - 300 * 0.1 / 100, 1e-12));
  CHECK(force == -300);
  force = 0, v = 0.1;
  v += shelf::wheel_grip(force, v, 0.01, 300.0, 0.1) / 100;
  CHECK_THAT(v, WithinAbs(0, 1e-15));
  CHECK_THAT(force, WithinRel(-100.0, 1e-12));
  // In the air it holds nothing, and gives back what was handed on.
  CHECK_THAT(shelf::wheel_grip(force, 0.0, 0.01, 0.0, 0.1), WithinRel(10.0, 1e-12));
  CHECK(force == 0);
}

TEST_CASE("Eight passes over four tyres hold what each alone would hold too hard") {
  double v = 0, grip[4] = {0, 0, 0, 0};
  for (int n = 0; n < 600; ++n) {
    v += 1.0 / 60;
    for (const double held : grip) v += held / 60 / 1200;
    for (int pass = 0; pass < 8; ++pass) {
      for (double& held : grip)
        v += shelf::wheel_grip(held, v, 4 / 1200.0, 2000.0, 1 / 60.0) / 1200;
    }
    if (n > 60) REQUIRE(std::abs(v) < 1e-6);
  }
  double sum = 0;
  for (const double held : grip) sum += held;
  CHECK_THAT(sum, WithinRel(-1200.0, 1e-6));
}

TEST_CASE("Where no mass is felt a tyre only keeps its bound, and no number holds nothing back") {
  double force = 500;
  CHECK(shelf::wheel_grip(force, 3.0, 0.0, 300.0, 0.1) == 0.1 * -200);
  CHECK(force == 300);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  shelf::wheel_grip(force, nan, 0.01, 300.0, 0.1);
  CHECK(std::abs(force) == 300);
}
