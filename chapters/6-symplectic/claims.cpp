// SPDX-License-Identifier: MIT-0
// The claims of chapter 6. Each name is a sentence that the chapter says.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "ball.h"
#include "cat.h"
#include "drag.h"
#include "kicks.h"
#include "measure/energy.h"
#include "measure/error.h"
#include "measure/evaluations.h"
#include "measure/methods.h"
#include "measure/order.h"
#include "pair.h"
#include "planets.h"
#include "precession.h"
#include "scenes/projectile.h"
#include "shadow.h"
#include "uneven.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using measure::euler;
using measure::symplectic_euler;
using scenes::Spring;
using scenes::State;

namespace {

constexpr auto position_first = measure::symplectic_euler_position_first;

/// A spring with one as its frequency.
Spring<> unit(double zeta = 0) {
  return {.omega = 1, .zeta = zeta, .x0 = 1, .v0 = 0.5};
}

/// How much larger a cat has become.
template <class Step, class Scene>
double grown(Step step, const Scene& scene, double h, long steps, int parts = 500) {
  const auto start = cat(parts);
  return area(carried(step, scene, start, h, steps)) / area(start);
}

/// The speeds with which a ball hits the floor.
template <class Step>
std::vector<double> impacts(Step step, double h, std::size_t count) {
  std::vector<double> speeds;
  auto s = dropped;
  while (speeds.size() < count) {
    const bool down = s.v < 0;
    on_a_floor(step)(s.x, s.v, 0.0, h, falling);
    if (down && s.v > 0) speeds.push_back(s.v);
  }
  return speeds;
}

template <class Step>
double order_on_a_spring(Step step, double zeta) {
  return measure::halvings(step, unit(zeta), 0.05, 6.0, 4).back().position_order;
}

}  // namespace

TEST_CASE("After an hour of Euler the drone is farther away than the moon") {
  const auto end = measure::after(euler, drone, drone.start(), frame, 3600 * 60);
  CHECK(end.x.norm() > 2 * 384.4e6);
  CHECK(end.x.norm() < 3 * 384.4e6);
}

TEST_CASE("With two lines swapped the drone stays within four centimetres for an hour") {
  double off = 0;
  auto s = drone.start();
  measure::run(symplectic_euler, drone, s, frame, 3600 * 60, [&](double, const auto& now) {
    if (!(std::abs(now.x.norm() - 10) <= off)) off = std::abs(now.x.norm() - 10);
  });
  CHECK(off < 0.04);
  CHECK(off > 0.03);
}

TEST_CASE("A step of symplectic Euler and a step back do not undo each other, but its twin does") {
  State<double> s{0.3, -0.2};
  symplectic_euler(s.x, s.v, 0.0, 0.25, wrecking_ball);
  auto twin = s;
  symplectic_euler(s.x, s.v, 0.25, -0.25, wrecking_ball);
  CHECK(std::hypot(s.x - 0.3, s.v + 0.2) > 0.01);
  position_first(twin.x, twin.v, 0.25, -0.25, wrecking_ball);
  CHECK(std::hypot(twin.x - 0.3, twin.v + 0.2) < 1e-15);
}

TEST_CASE("A step of backward Euler undoes a step of Euler with the step reversed") {
  State<double> s{0.3, -0.2};
  euler(s.x, s.v, 0.25, -0.25, wrecking_ball);
  measure::backward_euler_newton(s.x, s.v, 0.0, 0.25, wrecking_ball);
  CHECK(std::hypot(s.x - 0.3, s.v + 0.2) < 1e-12);
}

TEST_CASE("A kick keeps the area of a cat, and so does a drift") {
  const auto start = cat(500);
  auto kicked = start, drifted = start;
  for (auto& point : kicked) point.v += 1.0 * wrecking_ball(point.x, point.v, 0.0);
  for (auto& point : drifted) point.x += 1.0 * point.v;
  // The outline has straight edges and a kick bends them: of 500 parts, each is off by 1e-7.
  CHECK_THAT(area(kicked), WithinRel(area(start), 1e-6));
  CHECK_THAT(area(drifted), WithinRel(area(start), 1e-13));
}

TEST_CASE("Symplectic Euler carries a cat round a pendulum and keeps its area") {
  const double off = std::abs(grown(symplectic_euler, wrecking_ball, cat_step, cat_steps, 50) - 1);
  const double fine = std::abs(grown(symplectic_euler, wrecking_ball, cat_step, cat_steps) - 1);
  CHECK(fine < 1e-6);
  CHECK_THAT(off / fine, WithinAbs(100, 5));  // what is left is that of straight edges
}

TEST_CASE("Euler's cat has nearly doubled, backward Euler's has lost more than half") {
  CHECK_THAT(grown(euler, wrecking_ball, cat_step, cat_steps), WithinAbs(1.93, 0.01));
  CHECK_THAT(grown(method::backward_euler_newton, wrecking_ball, cat_step, cat_steps),
             WithinAbs(0.39, 0.01));
}

TEST_CASE("On a spring a step of Euler multiplies every area by 1 + (h omega)^2") {
  for (const double h : {0.01, 0.1, 1.0}) {
    CHECK_THAT(grown(euler, unit(), h, 10), WithinRel(std::pow(1 + h * h, 10), 1e-12));
    CHECK_THAT(grown(symplectic_euler, unit(), h, 10), WithinRel(1, 1e-12));
    CHECK_THAT(grown(position_first, unit(), h, 10), WithinRel(1, 1e-12));
  }
}

TEST_CASE("Drag takes from every area the share c h that it should") {
  for (const double h : {0.01, 0.1, 0.4}) {
    CHECK_THAT(grown(symplectic_euler, unit(0.5), h, 10), WithinRel(std::pow(1 - h, 10), 1e-12));
  }
}

TEST_CASE("Symplectic Euler keeps the shadow energy of a spring to rounding") {
  for (const double h : {frame, 0.05, 0.09}) {
    const auto shadow = shadow_energy(undamped_suspension, h);
    CHECK(measure::drift(symplectic_euler, undamped_suspension, h, 100'000, shadow).largest <
          1e-11);
    const auto other = shadow_energy(undamped_suspension, -h);
    CHECK(measure::drift(position_first, undamped_suspension, h, 100'000, other).largest < 1e-11);
  }
}

TEST_CASE("A spring's energy stays between 1 / (1 + h omega / 2) and 1 / (1 - h omega / 2)") {
  for (const State<double> start : {State<double>{0.1, 0}, State<double>{0, 2}}) {
    for (const double homega : {0.1, 1.0 / 3, 1.5}) {
      const double h = homega / undamped_suspension.omega;
      const double full = undamped_suspension.energy(start.x, start.v);
      double least = INFINITY, most = 0;
      auto s = start;
      measure::run(symplectic_euler, undamped_suspension, s, h, 100'000,
                   [&](double, const auto& now) {
                     least = std::min(least, undamped_suspension.energy(now.x, now.v) / full);
                     most = std::max(most, undamped_suspension.energy(now.x, now.v) / full);
                   });
      CHECK_THAT(least, WithinRel(1 / (1 + homega / 2), 1e-3));
      CHECK_THAT(most, WithinRel(1 / (1 - homega / 2), 1e-3));
      CHECK(least > (1 - 1e-11) / (1 + homega / 2));
      CHECK(most < (1 + 1e-11) / (1 - homega / 2));
    }
  }
}

TEST_CASE("After an hour without a damper a spring swings as far as in its first second") {
  auto s = measure::after(symplectic_euler, undamped_suspension, undamped_suspension.start(), frame,
                          3600 * 60);
  Spring<> later = undamped_suspension;
  later.x0 = s.x, later.v0 = s.v;
  CHECK_THAT(swing(later, frame, 60), WithinRel(swing(undamped_suspension, frame, 60), 0.02));
}

TEST_CASE("Uneven steps of symplectic Euler swing a spring a million times too far in an hour") {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    INFO(seed);
    CHECK(uneven_swings(0.5, seed, 3600 * 60).symplectic_euler > 1e6 * undamped_suspension.x0);
  }
  CHECK(uneven_swings(0, 1, 3600 * 60).symplectic_euler < 1.02 * undamped_suspension.x0);
}

TEST_CASE("Every step keeps areas, also where steps are uneven") {
  UnevenSteps uneven{.random = std::mt19937(1)};
  auto points = cat(500);
  const double before = area(points);
  for (int n = 0; n < 600; ++n) {
    const double h = uneven.next();
    CHECK(h * undamped_suspension.omega <= 0.5);
    for (auto& point : points) symplectic_euler(point.x, point.v, 0.0, h, undamped_suspension);
  }
  CHECK_THAT(area(points), WithinRel(before, 1e-9));
}

TEST_CASE(
    "In three of four runs of uneven steps velocity Verlet's spring swings less than ten times too "
    "far") {
  constexpr int runs = 60;
  int near = 0;
  double most = 0;
  for (unsigned seed = 1; seed <= runs; ++seed) {
    const double far = uneven_swings(0.5, seed, 3600 * 60).velocity_verlet;
    near += far < 10 * undamped_suspension.x0;
    most = std::max(most, far);
  }
  CAPTURE(near);
  CHECK(4 * near >= 3 * runs);
  CHECK(most > 10 * undamped_suspension.x0);  // not in all
}

TEST_CASE("Symplectic Euler holds an undamped spring while h omega is less than two") {
  CHECK(swing(unit(), 1.999, 1'000'000) < 50);
}

TEST_CASE("Symplectic Euler loses an undamped spring when h omega is more than two") {
  CHECK(swing(unit(), 2.001, 1000) > 1e6);
}

TEST_CASE("At h omega = 1.9 a spring swings 3.2 times as far as it should, at 1.99 ten times") {
  const auto times = [](double homega) {
    return swing(undamped_suspension, homega / undamped_suspension.omega, 100'000) /
           undamped_suspension.x0;
  };
  CHECK_THAT(times(1.9), WithinAbs(3.2, 0.01));
  CHECK_THAT(times(1.99), WithinAbs(10, 0.02));
}

TEST_CASE("A spring's clock runs fast by a share of (h omega)^2 / 24") {
  for (const double h : {0.01, 0.05, 0.1}) {
    const auto step = measure::step_matrix(symplectic_euler, unit(), h);
    const double angle = std::acos(step.trace() / 2);
    CHECK_THAT(angle / h - 1, WithinRel(h * h / 24, 0.01));
  }
}

TEST_CASE("Started half a kick back, symplectic Euler takes the steps of leapfrog, bit for bit") {
  auto s = shuttle.start();
  auto hopping = s;
  hopping.v = integrate::leapfrog_start(s.x, s.v, 0.0, tick, shuttle);
  s.v = s.v - tick / 2 * shuttle(s.x, s.v, 0.0);
  for (int n = 0; n < 1000; ++n) {
    symplectic_euler(s.x, s.v, n * tick, tick, shuttle);
    integrate::leapfrog(hopping.x, hopping.v, n * tick, tick, shuttle);
  }
  CHECK(s.x == hopping.x);
  CHECK(s.v == hopping.v);
}

TEST_CASE("Started half a kick back, symplectic Euler goes through the places of velocity Verlet") {
  const auto hopping = measure::after(method::leapfrog, shuttle, shuttle.start(), tick, 1000);
  const auto kicked = measure::after(method::velocity_verlet, shuttle, shuttle.start(), tick, 1000);
  CHECK((hopping.x - kicked.x).norm() < 1e-9);
  CHECK((hopping.v - kicked.v).norm() < 1e-9);
  const auto plain = measure::after(symplectic_euler, shuttle, shuttle.start(), tick, 1000);
  CHECK((plain.x - kicked.x).norm() > 0.1);
}

TEST_CASE("Between two kicks the velocity is that of the middle of the step, to order two") {
  const auto off = [](double h, double from_the_tick) {
    double most = 0;
    for (const Kick& kick : kicks_of(undamped_suspension, h, int(std::lround(1 / h)))) {
      const double truth = undamped_suspension.exact(kick.t + from_the_tick * h).v;
      most = std::max(most, std::abs(kick.after - truth));
    }
    return most;
  };
  for (const double h : {frame, frame / 2, frame / 4}) {
    CHECK_THAT(off(h, 0.5) / off(h / 2, 0.5), WithinAbs(4, 0.2));
    CHECK_THAT(off(h, 1) / off(h / 2, 1), WithinAbs(2, 0.1));  // at the end of the step
  }
}

TEST_CASE("In the middle of each kick lies the velocity of velocity Verlet") {
  for (const Kick& kick : kicks_of(undamped_suspension, 3 * frame, 100))
    CHECK_THAT(kick.verlet, WithinAbs((kick.before + kick.after) / 2, 1e-12));
}

TEST_CASE("Symplectic Euler has order one, and two in position when started half a kick back") {
  const auto plain = measure::halvings(symplectic_euler, drone, 1.0 / 15, 8.0, 5);
  const auto started = measure::halvings(method::leapfrog, drone, 1.0 / 15, 8.0, 5);
  for (std::size_t i = 1; i < plain.size(); ++i) {
    CHECK_THAT(plain[i].position_order, WithinAbs(1, 0.1));
    CHECK_THAT(plain[i].velocity_order, WithinAbs(1, 0.1));
    CHECK_THAT(started[i].position_order, WithinAbs(2, 0.1));
    CHECK_THAT(started[i].velocity_order, WithinAbs(2, 0.1));
  }
}

TEST_CASE("On the drone RK4 is ten thousand times as accurate at the same price") {
  const double cheap = measure::largest_error(symplectic_euler, drone, frame, 480).position;
  const double rk4 = measure::largest_error(method::rk4, drone, 4 * frame, 120).position;
  CHECK(cheap / rk4 > 1e4);
  CHECK(measure::evaluations_per_step(method::rk4, drone, frame) ==
        4 * measure::evaluations_per_step(symplectic_euler, drone, frame));
}

TEST_CASE("Under a constant force symplectic Euler errs as far as Euler, to the other side") {
  for (const double h : {frame, 0.1, 1.0}) {
    const double t = 100 * h;
    const auto error = [&](auto step) {
      return measure::after(step, running_jump, running_jump.start(), h, 100).x.y() -
             running_jump.exact(t).x.y();
    };
    CHECK_THAT(error(euler), WithinRel(9.81 * h * t / 2, 1e-9));
    CHECK_THAT(error(symplectic_euler), WithinRel(-9.81 * h * t / 2, 1e-9));
  }
}

TEST_CASE("Started half a kick back, symplectic Euler follows a jump exactly") {
  for (const double h : {frame, 0.1, 1.0}) {
    auto s = running_jump.start();
    s.v = s.v - h / 2 * running_jump(s.x, s.v, 0.0);
    s = measure::after(symplectic_euler, running_jump, s, h, 100);
    CHECK((s.x - running_jump.exact(100 * h).x).norm() < 1e-12 * s.x.norm());
  }
}

TEST_CASE("Between two bounces a ball gains g h of speed under Euler, and loses it when swapped") {
  const auto up = impacts(euler, frame, 11), down = impacts(symplectic_euler, frame, 11);
  const double per_bounce = falling.g * frame;
  // The floor is met up to a step late, which is worth up to g h once.
  CHECK_THAT(up.back() - up.front(), WithinAbs(10 * per_bounce, per_bounce));
  CHECK_THAT(down.back() - down.front(), WithinAbs(-10 * per_bounce, per_bounce));
}

TEST_CASE("With the exact step a ball bounces as high after a hundred bounces") {
  // A top between two steps is seen g h^2 / 8 too low.
  CHECK_THAT(top_after(measure::constant_acceleration, frame, 100), WithinAbs(2, 0.0015));
}

TEST_CASE("Symplectic Euler keeps the angular momentum of an orbit to rounding") {
  const auto spin = [](auto& x, auto& v) { return shuttle.angular_momentum(x, v); };
  CHECK(measure::drift(symplectic_euler, shuttle, tick, 12'000, spin).largest < 1e-12);
  CHECK(measure::drift(euler, shuttle, tick, 12'000, spin).largest > 0.1);
  CHECK(measure::drift(method::rk4, shuttle, tick, 12'000, spin).largest > 1e-5);
}

TEST_CASE("After a thousand turns the shuttle is on an ellipse of the size that it began with") {
  auto s = measure::after(symplectic_euler, shuttle, shuttle.start(), tick, 130'000);
  double near = INFINITY, far = 0;
  measure::run(symplectic_euler, shuttle, s, tick, 240, [&](double, const auto& now) {
    near = std::min(near, now.x.norm());
    far = std::max(far, now.x.norm());
  });
  CHECK_THAT(near, WithinRel(4, 0.05));
  CHECK_THAT(far, WithinRel(16, 0.07));
}

TEST_CASE("At ten steps a second RK4's shuttle sinks in a thousand turns, symplectic Euler's not") {
  const double h = 0.1;
  const auto farthest = [h](auto step, long before) {
    auto s = measure::after(step, shuttle, shuttle.start(), h, before);
    double far = 0;
    measure::run(step, shuttle, s, h, 100,
                 [&](double, auto& now) { far = std::max(far, now.x.norm()); });
    return far;
  };
  CHECK(farthest(method::rk4, 27'000) < 14);
  CHECK(farthest(method::rk4, 54'000) < 10);
  for (const long steps : {27'000, 54'000, 81'000}) CHECK(farthest(symplectic_euler, steps) > 16);
}

namespace {

/// How often the shuttle is at its farthest in the time of a thousand turns, of which true turns
/// have a thousand, if it sets out some time after its nearest point [s].
int times_farthest(double h, double started = 0) {
  auto s = shuttle.exact(started);
  int times = 0;
  double before = INFINITY, last = INFINITY;
  measure::run(symplectic_euler, shuttle, s, h, std::lround(8000 / h), [&](double, auto& now) {
    const double out = now.x.norm();
    times += last > before && last > out;
    before = last;
    last = out;
  });
  return times;
}

}  // namespace

TEST_CASE("In the time of a thousand turns the shuttle makes 932 at 15 steps a second") {
  CHECK(times_farthest(tick) == 932);
  CHECK_THAT(1000 * shuttle_turn / turn_takes(symplectic_euler, tick), WithinAbs(932, 0.5));
  // Sixteen times smaller with four times the steps.
  CHECK_THAT(1000 - times_farthest(tick / 4), WithinAbs((1000 - 932) / 16.0, 1));
}

TEST_CASE("Started a second later on its ellipse the shuttle makes too many turns") {
  const int times = times_farthest(tick, 1);
  CHECK(times > 1050);
  CHECK_THAT(1000 * shuttle_turn / turn_takes(symplectic_euler, tick, 1), WithinAbs(times, 1));
}

TEST_CASE("The shuttle's ellipse turns by about a degree in a turn at 15 steps a second") {
  CHECK_THAT(turning(symplectic_euler, tick, 60), WithinAbs(-1.02, 0.01));
}

TEST_CASE("Four times the steps turn the ellipse a sixteenth as far") {
  CHECK_THAT(turning(symplectic_euler, tick / 2, 60) / turning(symplectic_euler, tick / 8, 60),
             WithinRel(16, 0.05));
}

TEST_CASE("On an orbit the shadow energy swings ten times less, and with the square of the step") {
  const auto energy = [](auto& x, auto& v) { return shuttle.energy(x, v); };
  const auto moves = [&](double h, auto invariant) {
    return measure::drift(symplectic_euler, shuttle, h, std::lround(80 / h), invariant).largest;
  };
  CHECK(moves(frame, shadow_energy(shuttle, frame)) < 0.1 * moves(frame, energy));
  const double fine = frame / 8;
  CHECK_THAT(moves(fine, energy) / moves(fine / 2, energy), WithinAbs(2, 0.1));
  CHECK_THAT(
      moves(fine, shadow_energy(shuttle, fine)) / moves(fine / 2, shadow_energy(shuttle, fine / 2)),
      WithinAbs(4, 0.1));
}

TEST_CASE("Drag in the acceleration shrinks the limit to 2 (sqrt(1 + zeta^2) - zeta)") {
  for (const double zeta : {0.0, 0.1, 0.5, 1.0, 2.0, 5.0}) {
    const double bound = 2 * (std::sqrt(1 + zeta * zeta) - zeta);
    CHECK_THAT(limit(method::symplectic_euler, zeta), WithinRel(bound, 1e-6));
    const auto size_after = [&](double h) {
      return std::abs(
          measure::after(symplectic_euler, unit(zeta), State<double>{1, 1}, h, 20'000).x);
    };
    CHECK(size_after(0.99 * bound) < 20);
    CHECK(!(size_after(1.01 * bound) < 1e10));
  }
}

TEST_CASE("From zeta = 1 / sqrt(3) on Euler takes longer steps than symplectic Euler") {
  const double equal = 1 / std::sqrt(3);
  CHECK_THAT(limit(method::euler, equal), WithinRel(limit(method::symplectic_euler, equal), 1e-6));
  for (const double more : {0.01, 0.1, 1.0, 10.0}) {
    CHECK(limit(method::euler, equal + more) > limit(method::symplectic_euler, equal + more));
  }
  for (const double less : {0.01, 0.1, 0.5}) {
    CHECK(limit(method::euler, equal - less) < limit(method::symplectic_euler, equal - less));
  }
}

TEST_CASE(
    "Divided by 1 + c h after the force, drag widens the limit to 2 (sqrt(1 + zeta^2) + zeta)") {
  for (const double zeta : {0.0, 0.1, 0.5, 1.0, 2.0}) {
    CHECK_THAT(limit(method::linear_damping_implicit_last, zeta),
               WithinRel(2 * (std::sqrt(1 + zeta * zeta) + zeta), 1e-6));
  }
}

TEST_CASE("Divided by 1 + c h before the force, drag shrinks the limit towards the root of two") {
  const auto bound = [](double zeta) { return limit(method::linear_damping_implicit_first, zeta); };
  CHECK_THAT(bound(0), WithinRel(2, 1e-6));
  CHECK_THAT(bound(1000), WithinRel(std::sqrt(2), 1e-3));
  CHECK(bound(0.5) < bound(0.1));
  CHECK(bound(5) < bound(0.5));
}

TEST_CASE("Of the six ways of drag only two end at the right speed") {
  const double right = leaf.g / leaf.c;
  for (const double rate : {20.0, 60.0}) {
    const double ch = leaf.c / rate;
    const std::array<double, 6> ends{
        1 - ch, 1, 1, 1 + ch, ch / std::expm1(ch), -ch / std::expm1(-ch)};
    std::size_t i = 0;
    for (const auto& [name, formula, step] : ways) {
      CAPTURE(name, rate);
      CHECK_THAT(end_speed(step, 1 / rate), WithinRel(right * ends[i++], 1e-9));
    }
    CHECK_THAT(end_speed(method::linear_damping_exact, 1 / rate), WithinRel(right, 1e-9));
  }
}

TEST_CASE("At a tenth of critical damping every way of drag has a limit, none farther than 2.43") {
  for (const auto& [name, formula, step] : ways) {
    CAPTURE(name);
    const double found = limit(step, 0.1);
    CHECK(found > 1.8);
    CHECK(found < 2.435);
    const auto size_after = [&](double h) {
      return std::abs(measure::after(step, unit(0.1), State<double>{1, 0.5}, h, 20'000).x);
    };
    CHECK(size_after(0.99 * found) < 10);
    CHECK(!(size_after(1.01 * found) < 1e10));
  }
}

TEST_CASE("The exponential after the force brakes a leaf 1.7 per cent too much at 60 Hz") {
  const double right = leaf.g / leaf.c;
  const auto last = method::linear_damping_exponential_last;
  CHECK_THAT(1 - end_speed(last, 1.0 / 60) / right, WithinAbs(0.017, 0.0005));
  CHECK_THAT(1 - end_speed(last, 1.0 / 20) / right, WithinAbs(0.049, 0.0005));
}

TEST_CASE("A damper divided out of the relative velocity leaves two thrown bodies their speed") {
  for (const Two mass : {Two{1, 1}, Two{4, 1}, Two{1, 100}}) {
    const Pair pair{.mass = mass};
    CHECK_THAT(speed_of_thrown(divide_between, pair), WithinRel(10, 1e-13));
    // What is between them is one spring with its own damper, divided as alone.
    Two x{0, 0.1}, v{10, 9};
    double apart = 0.1, opening = -1;
    const double pull = pair.stiffness * (1 / mass.a + 1 / mass.b);
    const auto spring = [&](double y, double, double) { return -pull * y; };
    for (int n = 0; n < 60; ++n) {
      divide_between(x, v, n * frame, frame, pair);
      integrate::linear_damping_implicit_last(apart, opening, n * frame, frame,
                                              pair.damper * (1 / mass.a + 1 / mass.b), spring);
    }
    CHECK_THAT(x.b - x.a, WithinAbs(apart, 1e-13));
    CHECK_THAT(v.b - v.a, WithinAbs(opening, 1e-12));
  }
}

namespace {

/// How far bodies of a kilogram in a row are apart at most, each tied to the next by a damped
/// spring whose damper is divided out of their relative velocity, one pair after the other.
double farthest_in_row(std::size_t bodies, double homega, double zeta = 1) {
  const double omega = homega / frame, k = omega * omega / 2, d = zeta * omega;  // of a pair
  std::vector<double> x(bodies), v(bodies);
  for (std::size_t i = 0; i < bodies; ++i) x[i] = i % 2 ? 0.01 : -0.01;
  double farthest = 0;
  for (int n = 0; n < 6000; ++n) {
    for (std::size_t i = 1; i < bodies; ++i) {
      const double impulse = frame * k * (x[i] - x[i - 1]);
      v[i - 1] += impulse;
      v[i] -= impulse;
    }
    for (std::size_t i = 1; i < bodies; ++i) {
      const double relative = v[i] - v[i - 1];
      const double impulse = (relative / (1 + 2 * d * frame) - relative) / 2;
      v[i - 1] -= impulse;
      v[i] += impulse;
    }
    for (std::size_t i = 0; i < bodies; ++i) x[i] += frame * v[i];
    for (std::size_t i = 1; i < bodies; ++i)
      farthest = std::max(farthest, std::abs(x[i] - x[i - 1]));
  }
  return farthest;
}

}  // namespace

TEST_CASE("Ten critically damped bodies in a row hold about a third of the step of a pair") {
  CHECK(farthest_in_row(2, 4.7) < 0.1);
  CHECK(farthest_in_row(2, 4.9) > 1e6);  // the limit of one spring, 2 (1 + the root of two)
  CHECK(farthest_in_row(10, 1.65) < 1);
  CHECK(farthest_in_row(10, 1.75) > 1e6);
  // Fewer and less damped, they may hold a longer step than the pair; undamped, a shorter one.
  CHECK(farthest_in_row(3, 2.8, 0.3) < 0.1);
  CHECK(farthest_in_row(2, 2.8, 0.3) > 1e6);
  CHECK(farthest_in_row(10, 1.5, 0) > 1e6);
  CHECK(farthest_in_row(2, 1.5, 0) < 0.1);
}

TEST_CASE("Thirty critically damped bodies in a row hold a shorter step than ten") {
  CHECK(farthest_in_row(30, 1.25) < 10);
  CHECK(farthest_in_row(30, 1.45) > 1e6);
  CHECK(farthest_in_row(10, 1.65) < 1);
}

TEST_CASE("A damper divided out of each velocity brakes two thrown bodies to a hundredth") {
  CHECK_THAT(speed_of_thrown(divide_each, Pair{}), WithinAbs(0.08, 0.005));
  CHECK_THAT(speed_of_thrown(divide_each, Pair{}),
             WithinRel(10 * std::pow(1 + 5.0 / 60, -60), 1e-9));
}

TEST_CASE("Drag that comes after the move lets things fall as fast as drag that comes first") {
  double x = 0, v = 0, before = 0;
  for (int n = 0; n < 2000; ++n) {
    before = x;
    v = v - frame * leaf.g;
    x = x + frame * v;
    v = v / (1 + leaf.c * frame);
  }
  CHECK_THAT((before - x) / frame,
             WithinRel(end_speed(method::linear_damping_implicit_first, frame), 1e-9));
  CHECK_THAT(-v, WithinRel(leaf.g / leaf.c, 1e-9));
}

TEST_CASE(
    "The last bit of its start decides whether a ball on a trampoline rises above two metres") {
  double start = 1, lowest = INFINITY, highest = 0;
  for (int n = 0; n < 20; ++n, start = std::nextafter(start, 2)) {
    const double height = highest_on_a_trampoline(frame, start);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  CHECK(lowest < 1.5);
  CHECK(highest > 2);
}

TEST_CASE(
    "Of 400 lengths of step within a tenth, a fifth to a quarter lift a ball on a trampoline above "
    "two metres, a third by less than five centimetres") {
  const auto found = all_highest_on_a_trampoline(0.9, 1.1);
  const auto up_to = [&](double height) {
    return double(std::upper_bound(found.begin(), found.end(), height) - found.begin()) /
           double(found.size());
  };
  CHECK_THAT(1 - up_to(2), WithinAbs(0.225, 0.025));
  CHECK(up_to(1.05) > 0.33);
}

TEST_CASE(
    "Of 400 lengths of step from a tenth to a quarter none lifts a ball on a trampoline by more "
    "than ten centimetres") {
  CHECK(all_highest_on_a_trampoline(0.1, 0.25).back() < 1.1);
}

TEST_CASE("Half a step of one twin and half a step of the other are a step of velocity Verlet") {
  auto s = shuttle.start();
  for (int n = 0; n < 100; ++n) {
    symplectic_euler(s.x, s.v, 0.0, tick / 2, shuttle);
    position_first(s.x, s.v, 0.0, tick / 2, shuttle);
  }
  const auto verlet = measure::after(method::velocity_verlet, shuttle, shuttle.start(), tick, 100);
  CHECK((s.x - verlet.x).norm() < 1e-11);
  CHECK((s.v - verlet.v).norm() < 1e-11);
}

TEST_CASE("Yoshida has order four on an undamped spring and order two on a damped one") {
  CHECK_THAT(order_on_a_spring(method::yoshida4, 0), WithinAbs(4, 0.1));
  CHECK_THAT(order_on_a_spring(method::yoshida4, 0.1), WithinAbs(2, 0.1));
  CHECK_THAT(order_on_a_spring(method::velocity_verlet, 0.1), WithinAbs(2, 0.1));
  CHECK_THAT(order_on_a_spring(method::rk4, 0.1), WithinAbs(4, 0.1));
}

TEST_CASE("Over one second of a spring RK4 is ahead of Yoshida at the same price") {
  for (const int price : {240, 960, 3840}) {
    const double rk4 =
        measure::largest_error(method::rk4, undamped_suspension, 4.0 / price, price / 4).position;
    const double yoshida =
        measure::largest_error(method::yoshida4, undamped_suspension, 3.0 / price, price / 3)
            .position;
    CHECK(rk4 < 0.5 * yoshida);
    CHECK(rk4 > 0.3 * yoshida);
  }
}

TEST_CASE("Under drag Yoshida is ten times worse than velocity Verlet at the same price") {
  const double verlet =
      measure::largest_error(method::velocity_verlet, suspension, 1.0 / 960, 960).position;
  const double yoshida =
      measure::largest_error(method::yoshida4, suspension, 1.0 / 320, 320).position;
  CHECK(yoshida > 10 * verlet);
  CHECK(yoshida < 20 * verlet);
}

TEST_CASE("Velocity Verlet forth and back comes home, but not under drag") {
  const auto away = [](double zeta) {
    auto s = State<double>{1, 0.5};
    s = measure::after(method::velocity_verlet, unit(zeta), s, 0.1, 1);
    s = measure::after(method::velocity_verlet, unit(zeta), s, -0.1, 1);
    return std::hypot(s.x - 1, s.v - 0.5);
  };
  CHECK(away(0) < 1e-15);
  CHECK(away(0.1) > 1e-7);
}

TEST_CASE("Yoshida loses an undamped spring beyond h omega = 1.573") {
  const auto size_after = [](double h) {
    return std::abs(measure::after(method::yoshida4, unit(), State<double>{1, 0.5}, h, 400).x);
  };
  CHECK(size_after(1.572) < 100);
  CHECK(size_after(1.575) > 1e10);
}

TEST_CASE("Backward Euler drops Jupiter into the sun within fourteen years") {
  const double h = all_days / evaluations;
  const Fate found = fate(method::backward_euler_newton, h, true_end(), [](double, double) {});
  CHECK(std::isnan(found.jupiter_off));
  CHECK(found.fall < 14 * 365.25);
  // On a circle each step takes 2 (h omega)^2 of the radius: r^3 falls evenly, to nothing after
  // 1 / (6 (h omega)^2) steps. Jupiter's mean motion is 2 pi in 4332.6 days.
  const double angle = h * 2 * std::numbers::pi / 4332.6;
  CHECK_THAT(found.fall / h, WithinRel(1 / (6 * angle * angle), 0.1));
}

TEST_CASE("On the planets RK4's energy error grows with the years, velocity Verlet's does not") {
  const auto growth = [truth = true_end()](const measure::Method& step, double h) {
    double at_fifty = 0;
    const Fate found = fate(step, h, truth, [&](double day, double largest) {
      if (day < 50 * 365.25) at_fifty = largest;
    });
    return found.largest / at_fifty;
  };
  const double h = all_days / evaluations;
  CHECK(growth(method::velocity_verlet, h) < 1.05);
  CHECK(growth(method::symplectic_euler, h) < 1.05);
  CHECK(growth(method::yoshida4, 3 * h) < 1.05);
  CHECK_THAT(growth(method::rk4, 4 * h), WithinRel(all_days / (50 * 365.25), 0.2));
}

TEST_CASE("RK4's energy error passes Yoshida's after about 20 years, velocity Verlet's after 200") {
  const auto truth = true_end();
  const double h = all_days / evaluations;
  const auto error_after = [&](const measure::Method& step, double step_size, double years) {
    double error = 0;
    fate(step, step_size, truth, [&](double day, double largest) {
      if (day <= years * 365.25) error = largest;
    });
    return error;
  };
  CHECK(error_after(method::rk4, 4 * h, 15) < error_after(method::yoshida4, 3 * h, 15));
  CHECK(error_after(method::rk4, 4 * h, 25) > error_after(method::yoshida4, 3 * h, 25));
  CHECK(error_after(method::rk4, 4 * h, 180) < error_after(method::velocity_verlet, h, 180));
  CHECK(error_after(method::rk4, 4 * h, 220) > error_after(method::velocity_verlet, h, 220));
}

TEST_CASE(
    "After five centuries Dormand-Prince's Jupiter is nearest, and RK4's nearer than Verlet's") {
  const auto truth = true_end();
  const double h = all_days / evaluations;
  const auto jupiter_error = [&](const measure::Method& step, double step_size) {
    return fate(step, step_size, truth, [](double, double) {}).jupiter_off;
  };
  const double rk4 = jupiter_error(method::rk4, 4 * h);
  const double nearest = jupiter_error(method::dopri5, 6 * h);
  CHECK(rk4 < 0.5 * jupiter_error(method::velocity_verlet, h));
  CHECK(nearest < 0.1 * rk4);
  CHECK(nearest < 0.2 * jupiter_error(method::trapezoid_newton, h));
  CHECK(nearest < 0.2 * jupiter_error(method::yoshida4, 3 * h));
}

TEST_CASE(
    "After five centuries the trapezoid rule's Jupiter is twelve times nearer than Verlet's") {
  const double h = all_days / evaluations;
  const auto jupiter_error = [truth = true_end(), h](const measure::Method& step) {
    return fate(step, h, truth, [](double, double) {}).jupiter_off;
  };
  CHECK_THAT(jupiter_error(method::velocity_verlet) / jupiter_error(method::trapezoid_newton),
             WithinAbs(12, 0.5));
}

TEST_CASE(
    "For five centuries symplectic Euler holds the planets' energy within a third of a per cent") {
  const Fate found =
      fate(method::symplectic_euler, all_days / evaluations, true_end(), [](double, double) {});
  CHECK(found.largest < 1.0 / 300);
  CHECK(found.largest > 1.0 / 1000);
}

TEST_CASE("With steps of a hundred days the planets' energy wanders by two and a half per cent") {
  const Fate found = fate(method::symplectic_euler, 100.0, true_end(), [](double, double) {});
  CHECK_THAT(found.largest, WithinAbs(0.0253, 0.0001));
}

TEST_CASE("Half a kick back at the start brings Jupiter six times closer to its place") {
  const double h = all_days / evaluations;
  const auto truth = true_end();
  const auto jupiter_error = [&](const measure::Method& step) {
    return fate(step, h, truth, [](double, double) {}).jupiter_off;
  };
  CHECK_THAT(jupiter_error(method::symplectic_euler) / jupiter_error(method::leapfrog),
             WithinAbs(6.5, 0.5));
}

TEST_CASE("A critically damped camera of 12 per second needs 14.5 steps a second, or 2.5 divided") {
  const auto rate = [](auto step) {
    return 1 / measure::stability_limit(step, Spring<>{.omega = 12, .zeta = 1}, 1e-6, 1);
  };
  CHECK_THAT(rate(symplectic_euler), WithinAbs(14.5, 0.05));
  CHECK_THAT(rate(method::linear_damping_implicit_last), WithinAbs(2.5, 0.05));
}

TEST_CASE("With drag split off on both sides Yoshida has order four on a damped spring") {
  const auto split = [](auto& x, auto& v, auto, auto h, const auto& spring) {
    const double outer = h / (2 - std::cbrt(2.0));
    for (const double part : {outer, h - 2 * outer, outer}) {
      const double brake = std::exp(-spring.damping() * part / 2);
      const double stiffness = spring.omega * spring.omega;
      v = brake * v - part / 2 * stiffness * x;
      x = x + part * v;
      v = brake * (v - part / 2 * stiffness * x);
    }
  };
  CHECK_THAT(order_on_a_spring(split, 0.1), WithinAbs(4, 0.1));
}
