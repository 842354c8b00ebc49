// SPDX-License-Identifier: MIT-0
// The claims of chapter 1. Each name is a sentence that the chapter says.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "ball.h"
#include "frames/recorded.h"
#include "integrate/rk4.h"
#include "jump.h"
#include "measure/methods.h"
#include "measure/order.h"
#include "runner.h"
#include "scenes/constant_velocity.h"
#include "scenes/friction.h"
#include "scenes/linear_drag.h"
#include "scenes/orbit.h"
#include "scenes/pendulum.h"
#include "scenes/spring.h"
#include "shelf/fixed_step.h"
#include "shot.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using measure::constant_acceleration;
using measure::euler;

namespace {

/// The heights of a jump of a second, frame after frame; `advance` is given the length of a frame.
template <class Advance>
std::vector<double> heights(std::size_t first_frame, Advance advance) {
  frames::Playback recording{.at = first_frame};
  auto s = jump.start();
  std::vector<double> seen;
  for (double t = 0, length; t < 1; t += length) {
    length = recording.next();
    advance(length, s, seen);
  }
  return seen;
}

/// The frames of a second on a machine one of whose frames takes a tenth of a second [s].
std::vector<double> frames_with_a_late_one(int rate, int late) {
  std::vector<double> lengths(std::size_t(rate), 1.0 / rate);
  lengths[std::size_t(late)] = 0.1;
  return lengths;
}

double highest_when_step_follows_frame(std::size_t first_frame) {
  const auto seen = heights(first_frame, [](double length, auto& s, auto& states) {
    integrate::euler(s.x, s.v, 0.0, length, jump);
    states.push_back(s.x.y());
  });
  return *std::max_element(seen.begin(), seen.end());
}

/// The longest of a jump's frames that end on the way up [s].
double longest_frame_up(std::size_t first_frame) {
  frames::Playback recording{.at = first_frame};
  double longest = 0;
  for (double t = recording.next(), last = t; t < 5 / 9.81; last = recording.next(), t += last) {
    longest = std::max(longest, last);
  }
  return longest;
}

std::vector<double> states_with_fixed_step(std::size_t first_frame) {
  shelf::FixedStep<> clock;
  auto seen = heights(first_frame, [&](double length, auto& s, auto& states) {
    clock.frame(length, [&](double t) {
      integrate::euler(s.x, s.v, t, clock.h, jump);
      states.push_back(s.x.y());
    });
  });
  seen.resize(50);
  return seen;
}

/// Where a ball at 3 m/s is drawn, on a screen of 144 frames a second with 60 steps a second.
struct Drawn {
  std::vector<double> newest, blended, extrapolated, true_place;
};

Drawn drawn_ball(int frames) {
  shelf::FixedStep<> clock;
  Drawn drawn;
  double before = 0, now = 0;
  for (int shown = 1; shown <= frames; ++shown) {
    clock.frame(1.0 / 144, [&](double) {
      before = now;
      now = 3 * clock.h * double(clock.steps);
    });
    drawn.newest.push_back(now);
    drawn.blended.push_back(before + clock.blend() * (now - before));
    drawn.extrapolated.push_back(now + 3 * clock.saved);
    drawn.true_place.push_back(3.0 * shown / 144);
  }
  return drawn;
}

float drifted(float distance, float rate) {
  float x = distance;
  for (int n = 0; n < int(10 * rate); ++n) x = x + (1 / rate) * 0.1f;
  return x - distance;
}

/// The largest error of a step anywhere between the origin and `distance`, as a share of the step.
double worst_step(float distance, float rate, float speed) {
  const float step = (1 / rate) * speed;
  double worst = 0;
  for (int place = 0; place <= 100'000; ++place) {
    const float x = distance * float(place) / 100'000;
    const double moved = double(x + step) - double(x);
    worst = std::max(worst, std::abs(moved / double(step) - 1));
  }
  return worst;
}

}  // namespace

TEST_CASE("A ledge at 1.33 m is in reach at 30 frames a second and out of reach at 60") {
  CHECK(apex(euler, 30) > 1.33);
  CHECK(apex(euler, 60) < 1.33);
  CHECK(apex(euler, 144) < apex(euler, 60));
}

TEST_CASE(
    "One frame of a tenth of a second that ends before the top lifts any of four machines above a "
    "ledge at 1.33 m") {
  for (const int rate : {20, 30, 60, 144}) {
    for (int late = 0; late / double(rate) + 0.1 < 5 / 9.81; ++late) {
      auto s = jump.start();
      double top = 0;
      for (const double length : frames_with_a_late_one(rate, late)) {
        integrate::euler(s.x, s.v, 0.0, length, jump);
        top = std::max(top, s.x.y());
      }
      CHECK(top > 1.33);
    }
  }
}

TEST_CASE("In steps of a sixtieth no late frame lifts a jump above a ledge at 1.33 m") {
  for (const int rate : {20, 30, 60, 144}) {
    for (int late = 0; late < rate; ++late) {
      shelf::FixedStep<> clock;
      auto s = jump.start();
      double top = 0;
      for (const double length : frames_with_a_late_one(rate, late)) {
        clock.frame(length, [&](double t) {
          integrate::euler(s.x, s.v, t, clock.h, jump);
          top = std::max(top, s.x.y());
        });
      }
      CHECK(top == apex(euler, 60));
    }
  }
  CHECK(apex(euler, 60) < 1.33);
}

TEST_CASE("With the velocity moved first a jump is too low by nearly as much") {
  const double truth = 25 / (2 * 9.81);
  for (const int rate : {20, 30, 60, 144}) {
    double x = 0, v = 5, top = 0;
    while (v > 0) {
      v += -9.81 / rate;
      x += v / rate;
      top = std::max(top, x);
    }
    CHECK_THAT(truth - top, WithinRel(apex(euler, rate) - truth, 0.05));
  }
}

TEST_CASE("The corners above the line are what the three lines jump too high") {
  for (const int rate : {20, 30, 60, 144}) {
    double corners = 0;
    auto s = jump.start();
    for (int n = 0; n < rate / 2; ++n) {
      const double first = s.v.y();
      euler(s.x, s.v, 0.0, 1.0 / rate, jump);
      corners += (first - s.v.y()) / rate / 2;  // a triangle
    }
    CHECK_THAT(too_high(euler, rate, 0.5), WithinRel(corners, 1e-12));
  }
}

TEST_CASE("A constant velocity is followed exactly by a step of any length") {
  const scenes::ConstantVelocity<> drifting;
  for (const double h : {1.0 / 60, 3600.0, 365.25 * 86400}) {
    auto s = drifting.start();
    integrate::euler(s.x, s.v, 0.0, h, drifting);
    CHECK((s.x - drifting.exact(h).x).norm() <= 1e-15 * s.x.norm());
    CHECK(s.v == drifting.exact(h).v);
  }
}

TEST_CASE("One long exact step and twelve short ones land a cannonball in the same place") {
  const double landing = 2 * 30 / 9.81;
  const auto start = cannonball.start();
  const auto once = measure::after(constant_acceleration, cannonball, start, landing, 1);
  const auto often = measure::after(constant_acceleration, cannonball, start, landing / 12, 12);
  CHECK((once.x - often.x).norm() < 1e-12 * once.x.norm());
}

TEST_CASE(
    "The cannonball of one long step comes down at height zero, to a billionth of a millimetre") {
  const double landing = 2 * 30 / 9.81;
  const auto end =
      measure::after(constant_acceleration, cannonball, cannonball.start(), landing, 1);
  CHECK_THAT(end.x.y(), WithinAbs(0, 1e-12));
}

TEST_CASE("With the exact step every frame of a jump lies on the true path, at any frame rate") {
  for (const int rate : {20, 30, 60, 144}) {
    auto s = jump.start();
    long frames = 0;
    measure::run(constant_acceleration, jump, s, 1.0 / rate, rate, [&](double t, const auto& now) {
      ++frames;
      CHECK_THAT(now.x.y(), WithinAbs(5 * t - 9.81 / 2 * t * t, 1e-13));
    });
    CHECK(frames == rate + 1);
  }
}

TEST_CASE("Drawn by the exact step, the top of a jump is missed by less than half a millimetre") {
  for (const int rate : {20, 30, 60, 144}) {
    const double drawn = apex(constant_acceleration, rate);
    CHECK(drawn < 5 * 5 / (2 * 9.81));
    CHECK(drawn > 5 * 5 / (2 * 9.81) - 0.0005);
  }
}

TEST_CASE("In air the cannonball's shot comes down 99.5 m away") {
  const auto start = cannonball.start();
  double lowest = 0;
  const Landing down =
      land_in_air(start, [&](double, const auto& now) { lowest = std::min(lowest, now.x.y()); });
  CHECK(lowest == 0);
  CHECK_THAT(down.x, WithinAbs(99.5, 0.05));
  // Another method, in other steps, with the last one cut where it meets the ground.
  auto s = start;
  const double h = 1.0 / 256;
  double t = 0, cut = h;
  for (auto next = s; cut > 1e-12; next = s) {
    integrate::rk4(next.x, next.v, t, cut, heavy_air);
    if (next.x.y() < 0) {
      cut /= 2;
    } else {
      s = next;
      t += cut;
    }
  }
  CHECK_THAT(s.x.y(), WithinAbs(0, 1e-9));
  CHECK_THAT(down.x, WithinAbs(s.x.x(), 0.005));
  CHECK_THAT(down.t, WithinAbs(t, 0.0005));
}

TEST_CASE("In air one step of Galileo's formula ends behind the cannon and underground") {
  const Landing down = land_in_air(cannonball.start(), [](double, const auto&) {});
  const auto s = measure::after(constant_acceleration, heavy_air, cannonball.start(), down.t, 1);
  CHECK(s.x.x() < 0);
  CHECK(s.x.y() < 0);
}

TEST_CASE("In air ten steps of the three lines end nearer than ten of Galileo's formula") {
  const Landing down = land_in_air(cannonball.start(), [](double, const auto&) {});
  CHECK(off_landing(euler, down) < off_landing(constant_acceleration, down) / 4);
  // One step of the lines is off as well: it is the looking that helps.
  const auto once = measure::after(euler, heavy_air, cannonball.start(), down.t, 1);
  CHECK((once.x - Eigen::Vector2d(down.x, 0)).norm() > 40 * off_landing(euler, down));
}

TEST_CASE(
    "In fixed steps the highest picture of a jump is within 1.2 mm of the others at 20, 30, 60 and "
    "144 frames a second") {
  double lowest = 10, highest = 0;
  for (const int rate : {20, 30, 60, 144}) {
    shelf::FixedStep<> clock{.h = frame};
    auto before = jump.start(), now = before;
    double top = 0;
    for (int n = 0; n < rate; ++n) {
      clock.frame(1.0 / rate, [&](double t) {
        before = now;
        integrate::euler(now.x, now.v, t, clock.h, jump);
      });
      top = std::max(top, (before.x + clock.blend() * (now.x - before.x)).y());
    }
    lowest = std::min(lowest, top);
    highest = std::max(highest, top);
  }
  CHECK(highest - lowest < 1.2e-3);
  CHECK(highest - lowest > 1e-3);
  CHECK(highest < 1.33);
}

TEST_CASE("The constant formula leaves a burning rocket far below where it is") {
  const auto s = measure::after(constant_acceleration, rocket, rocket.start(), rocket.burn_time, 1);
  CHECK(s.x < 0.7 * rocket.exact(rocket.burn_time).x);
}

TEST_CASE("Ten Euler steps follow a rocket better than one step of the constant formula") {
  const double truth = rocket.exact(rocket.burn_time).x;
  const double once =
      measure::after(constant_acceleration, rocket, rocket.start(), rocket.burn_time, 1).x;
  const double ten = measure::after(euler, rocket, rocket.start(), rocket.burn_time / 10, 10).x;
  CHECK(std::abs(ten - truth) < std::abs(once - truth));
}

TEST_CASE("Halfway through the burn ten Euler steps run below the constant formula, then above") {
  const double step = rocket.burn_time / 10;
  const auto height = [&](auto method, double h, long steps) {
    return measure::after(method, rocket, rocket.start(), h, steps).x;
  };
  for (long n = 1; n <= 5; ++n) {
    CHECK(height(euler, step, n) < height(constant_acceleration, double(n) * step, 1));
  }
  CHECK(height(euler, step, 10) > 1.2 * height(constant_acceleration, 10 * step, 1));
}

TEST_CASE("Euler's method has order one on a falling leaf") {
  const auto study = measure::halvings(euler, leaf, 1.0 / 64, 4.0, 5);
  for (std::size_t i = 1; i < study.size(); ++i) {
    CHECK_THAT(study[i].position_order, WithinAbs(1, 0.1));
    CHECK_THAT(study[i].velocity_order, WithinAbs(1, 0.1));
  }
}

TEST_CASE("On a falling leaf the term with half a h squared leaves the order at one") {
  const auto study = measure::halvings(constant_acceleration, leaf, 1.0 / 64, 4.0, 5);
  for (std::size_t i = 1; i < study.size(); ++i) {
    CHECK_THAT(study[i].position_order, WithinAbs(1, 0.1));
    CHECK_THAT(study[i].velocity_order, WithinAbs(1, 0.1));
  }
}

TEST_CASE(
    "On a falling leaf the term with half a h squared makes the error more than twice as large") {
  const auto plain = measure::halvings(euler, leaf, 1.0 / 64, 4.0, 5);
  const auto curved = measure::halvings(constant_acceleration, leaf, 1.0 / 64, 4.0, 5);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    CHECK(curved[i].error.position > 2 * plain[i].error.position);
    CHECK(curved[i].error.velocity == plain[i].error.velocity);
  }
}

TEST_CASE("In air the term with half a h squared makes a thrown ball's error larger") {
  for (const int rate : {10, 20, 30, 60, 144}) {
    const double h = 1.0 / rate;
    const double plain = measure::largest_error(euler, in_air, h, 2 * rate).position;
    const double curved =
        measure::largest_error(constant_acceleration, in_air, h, 2 * rate).position;
    CHECK(curved > plain);
    CHECK(measure::largest_error(constant_acceleration, in_a_vacuum, h, 2 * rate).position < 1e-12);
  }
}

TEST_CASE("Without air, Euler's error does not depend on the throw") {
  for (const int rate : {5, 20, 240}) {
    const double h = 1.0 / rate;
    const double error = measure::largest_error(euler, in_a_vacuum, h, 2 * rate).position;
    for (const auto& [across, up] : {std::pair{2.0, 0.0}, {5.0, 11.0}, {10.5, 3.0}}) {
      Ball ball = in_a_vacuum;
      ball.across.v0 = across;
      ball.up.v0 = up;
      CHECK_THAT(measure::largest_error(euler, ball, h, 2 * rate).position,
                 WithinRel(error, 1e-10));
    }
  }
}

TEST_CASE("A jump is too high by half of h v, and by up to an eighth of g h h more") {
  const double v = jump.start_velocity.y(), g = 9.81, truth = v * v / (2 * g);
  for (const int rate : {20, 30, 60, 144}) {
    const double h = 1.0 / rate, more = apex(euler, rate) - truth - h * v / 2;
    CHECK(more > 0);
    CHECK(more <= g * h * h / 8);
  }
}

TEST_CASE("When the step follows the frame, three of ten equal jumps reach a ledge at 1.33 m") {
  int reached = 0;
  double lowest = INFINITY, highest = 0;
  for (std::size_t jumps = 0; jumps < 10; ++jumps) {
    const double top = highest_when_step_follows_frame(60 * jumps);
    reached += top > 1.33;
    CHECK((top > 1.33) == (longest_frame_up(60 * jumps) > 0.06));
    lowest = std::min(lowest, top);
    highest = std::max(highest, top);
  }
  CHECK(reached == 3);
  CHECK_THAT(highest - lowest, WithinAbs(0.032, 0.001));
}

TEST_CASE("With a fixed step, uneven frames do not change one bit of a jump") {
  const auto first = states_with_fixed_step(0);
  for (std::size_t jumps = 1; jumps < 10; ++jumps) {
    CHECK(states_with_fixed_step(60 * jumps) == first);
  }
}

TEST_CASE("What is saved up is always less than a step") {
  shelf::FixedStep<> clock{.h = 1.0 / 60};
  double most = 0;
  for (const double length : frames::recorded) {
    clock.frame(length, [](double) {});
    REQUIRE(clock.saved >= 0);
    REQUIRE(clock.saved < clock.h);
    most = std::max(most, clock.saved);
  }
  CHECK(most > 0.9 * clock.h);  // and nearly all of one at times
}

TEST_CASE("A frame of ten seconds is paid for with a quarter of a second of steps") {
  shelf::FixedStep<> clock;
  int steps = 0;
  clock.frame(10.0, [&](double) { ++steps; });
  CHECK(steps == 15);
  CHECK(clock.saved < clock.h);
}

TEST_CASE(
    "Drawn from the newest state, more than half of the frames of a fast screen show no motion") {
  const Drawn ball = drawn_ball(1440);
  int still = 0;
  for (std::size_t i = 1; i < ball.newest.size(); ++i)
    still += ball.newest[i] == ball.newest[i - 1];
  CHECK(still > 720);
}

TEST_CASE("Blended, every frame moves a steady runner by the same amount") {
  const Drawn ball = drawn_ball(1440);
  for (std::size_t i = 4; i < ball.blended.size(); ++i) {
    CHECK_THAT(ball.blended[i] - ball.blended[i - 1], WithinAbs(3.0 / 144, 1e-12));
  }
}

TEST_CASE("A blended picture of a steady runner is one step behind the clock") {
  const Drawn ball = drawn_ball(1440);
  for (std::size_t i = 4; i < ball.blended.size(); ++i) {
    CHECK_THAT((ball.true_place[i] - ball.blended[i]) / 3, WithinAbs(1.0 / 60, 1e-12));
  }
}

TEST_CASE("Extrapolated, a steady runner is drawn where he is") {
  const Drawn ball = drawn_ball(1440);
  for (std::size_t i = 0; i < ball.extrapolated.size(); ++i) {
    CHECK_THAT(ball.extrapolated[i], WithinAbs(ball.true_place[i], 1e-12));
  }
}

TEST_CASE(
    "At a wall an extrapolated runner is drawn up to a step's way inside it, a blended one "
    "never") {
  for (const int rate : {20, 60}) {
    double deepest = 0, least = 1, deepest_blended = -1;
    for (int start = 0; start < 100; ++start) {
      shelf::FixedStep<> clock{.h = 1.0 / rate};
      Runner before{.x = room - 1 - 0.01 * start}, now = before;
      double deep = 0;
      for (int shown = 0; shown < 2 * 144; ++shown) {
        clock.frame(1.0 / 144, [&](double) {
          before = now;
          now.step(clock.h);
        });
        deep = std::max(deep, now.x + clock.saved * now.v - room);
        deepest_blended =
            std::max(deepest_blended, before.x + clock.blend() * (now.x - before.x) - room);
      }
      deepest = std::max(deepest, deep);
      least = std::min(least, deep);
    }
    const double way = 3.0 / rate;
    CHECK(deepest < way);
    CHECK(deepest > 0.95 * way);
    CHECK(least < 0.1 * way);
    CHECK(deepest_blended <= 0);
  }
}

TEST_CASE("In single precision a drifting boat stands still sixteen kilometres out") {
  CHECK(drifted(16'000, 240) == 0);
  CHECK_THAT(drifted(0, 240), WithinRel(1.0f, 1e-4f));
  CHECK(drifted(4'000, 240) > 1.1f);
}

TEST_CASE("Four kilometres out, a boat that drifts at 240 steps a second stands still at 960") {
  CHECK(drifted(4'000, 240) > 0);
  CHECK(drifted(4'000, 960) == 0);
}

TEST_CASE(
    "In single precision steps of a walk are right to three per cent up to 16 km, of a boat to "
    "250 m") {
  CHECK(worst_step(16'000, 60, 1.4f) < 0.03);
  CHECK(worst_step(250, 240, 0.1f) < 0.03);
  // Where the next gaps begin, twice as wide, a step may be off by more.
  const auto half_gap = [](float place) { return (std::nextafter(place, INFINITY) - place) / 2.0; };
  CHECK(half_gap(16'000) < 0.03 * 1.4 / 60);
  CHECK(half_gap(17'000) > 0.03 * 1.4 / 60);
  CHECK(half_gap(250) < 0.03 * 0.1 / 240);
  CHECK(half_gap(270) > 0.03 * 0.1 / 240);
}

TEST_CASE("A float clock that adds up steps is wrong by more than ten minutes after a night") {
  float clock = 0;
  for (long n = 0; n < 8L * 3600 * 60; ++n) clock = clock + 1 / 60.0f;
  CHECK(std::abs(double(clock) - 8 * 3600) > 600);
}

TEST_CASE("A clock that multiplies is right to rounding after a night") {
  shelf::FixedStep<> clock;
  clock.steps = 8L * 3600 * 60;
  double now = 0;
  clock.frame(clock.h, [&](double t) { now = t; });
  CHECK_THAT(now, WithinRel(8 * 3600.0, 1e-15));
}

TEST_CASE("A hitch of 100 ms before the top lifts a jump by four centimetres") {
  auto even = measure::after(euler, jump, jump.start(), frame, 30);
  for (const int before : {0, 12, 24}) {
    auto s = measure::after(euler, jump, jump.start(), frame, before);
    integrate::euler(s.x, s.v, 0.0, 0.1, jump);
    s = measure::after(euler, jump, s, frame, 24 - before);
    CHECK_THAT(s.x.y() - even.x.y(), WithinAbs(0.04, 0.002));
  }
}

TEST_CASE("A ball of 50 m/s hits a target 150 m away at 18 and at 72 degrees") {
  for (const double degrees : {18.0, 72.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const double flight = 2 * 50 * std::sin(angle) / 9.81;
    const scenes::Projectile<> ball{.start_velocity = {50 * std::cos(angle), 50 * std::sin(angle)}};
    CHECK_THAT(ball.exact(flight).x.x(), WithinAbs(150, 0.5));
    CHECK_THAT(ball.exact(flight).x.y(), WithinAbs(0, 1e-9));
  }
}

TEST_CASE("At 1000 steps a second a float that moves at 1 mm/s stops 32 m from the origin") {
  const float step = 0.001f * 0.001f;
  CHECK(31.9f + step > 31.9f);
  CHECK(32.0f + step == 32.0f);
}

TEST_CASE("A spring without a damper, an orbit and a pendulum pull the same at every speed") {
  const scenes::Spring<> spring{.omega = 3}, damped{.omega = 3, .zeta = 0.1};
  CHECK(spring(0.5, 0.0, 0.0) == spring(0.5, 7.0, 0.0));
  CHECK(damped(0.5, 0.0, 0.0) != damped(0.5, 7.0, 0.0));
  const scenes::Pendulum<> pendulum{};
  CHECK(pendulum(0.5, 0.0, 0.0) == pendulum(0.5, 7.0, 0.0));
  const scenes::Orbit<> orbit{};
  const Eigen::Vector2d place{1, 2};
  CHECK(orbit(place, {0, 0}, 0.0) == orbit(place, {3, -4}, 0.0));
}

TEST_CASE("Drag grows with the speed, and dry friction knows only its direction") {
  const scenes::LinearDrag<> drag{.c = 2, .g = 0};
  CHECK(drag(0.0, 2.0, 0.0) == 2 * drag(0.0, 1.0, 0.0));
  const scenes::Friction<> table{};
  CHECK(table(0.0, 2.0, 0.0) == table(0.0, 1.0, 0.0));
  CHECK(table(0.0, -2.0, 0.0) == -table(0.0, 1.0, 0.0));
}
