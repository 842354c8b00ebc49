// SPDX-License-Identifier: MIT-0
// The claims of chapter 2. Each name is a sentence that the chapter says.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "../cast.h"
#include "blob.h"
#include "hitch.h"
#include "machines.h"
#include "measure/energy.h"
#include "measure/error.h"
#include "measure/evaluations.h"
#include "measure/methods.h"
#include "measure/order.h"
#include "measure/stability.h"
#include "planets.h"
#include "scenes/friction.h"
#include "shelf/smooth_damp.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using measure::euler;
using scenes::LinearDrag;
using scenes::Spring;
using scenes::State;

namespace {

const auto energy = [](const auto& x, const auto& v) { return drone.energy(x, v); };
const auto spin = [](const auto& x, const auto& v) { return drone.angular_momentum(x, v); };

/// The size of a spring's state after many steps, from a start with both position and velocity.
double size_after(long steps, const Spring<>& spring, double step) {
  const auto end = measure::after(euler, spring, State<double>{1, spring.omega}, step, steps);
  return std::hypot(end.x, end.v / spring.omega);
}

/// Without gravity, so that a fall has nothing to do but stop.
const LinearDrag<> braking{.c = 2, .g = 0, .v0 = 10};

double speed_after(double ch, long steps) {
  return measure::after(euler, braking, braking.start(), ch / braking.c, steps).v;
}

auto after_ten_day_steps(const State<Planets::Vec>& start) {
  return measure::after(euler, outer_planets, start, days, planet_steps);
}

}  // namespace

TEST_CASE("Euler gains energy on every step of a circle") {
  for (const double step : {1e-4, frame, 0.1, 1.0}) {
    CHECK(measure::drift(euler, drone, step, 1000, energy).smallest_gain > 0);
  }
}

TEST_CASE("Every step of a circle multiplies the energy by 1 + (h omega)^2") {
  for (const double step : {frame, 0.1, 1.0}) {
    const double growth = 1 + std::pow(step * drone.omega, 2);
    const auto drift = measure::drift(euler, drone, step, 100, energy);
    CHECK_THAT(1 + drift.last, WithinRel(std::pow(growth, 100), 1e-12));
    CHECK_THAT(1 + drift.smallest_gain, WithinRel(growth, 1e-12));
  }
}

TEST_CASE("The angular momentum of the drone grows by the same factor as its energy") {
  for (const double step : {frame, 0.1, 1.0}) {
    const double growth = measure::drift(euler, drone, step, 50, energy).last;
    CHECK_THAT(measure::drift(euler, drone, step, 50, spin).last, WithinRel(growth, 1e-10));
  }
}

TEST_CASE("Each step of the drone ends outside the circle that it started on") {
  auto s = drone.start();
  double before = s.x.norm();
  for (int n = 0; n < 5000; ++n) {
    integrate::euler(s.x, s.v, 0.0, frame, drone);
    CHECK(s.x.norm() > before);
    before = s.x.norm();
  }
}

TEST_CASE("The drone at 60 steps a second is over its fence after four turns and before five") {
  const auto distance = [](double turns) {
    return measure::after(euler, drone, drone.start(), frame, std::lround(turns * turn)).x.norm();
  };
  CHECK(distance(4) < fence);
  CHECK(distance(5) > fence);
}

TEST_CASE("Four times the steps take a quarter of the growth in a minute") {
  const double coarse = std::log1p(measure::drift(euler, drone, frame, 3600, energy).last);
  const double fine = std::log1p(measure::drift(euler, drone, frame / 4, 4 * 3600, energy).last);
  CHECK_THAT(coarse / fine, WithinRel(4, 0.01));
}

TEST_CASE("Euler has order one on the drone, in position and in velocity") {
  const auto study = measure::halvings(euler, drone, 1.0 / 60, 8.0, 6);
  for (std::size_t i = 1; i < study.size(); ++i) {
    CHECK_THAT(study[i].position_order, WithinAbs(1, 0.1));
    CHECK_THAT(study[i].velocity_order, WithinAbs(1, 0.1));
  }
}

TEST_CASE("Euler asks for the acceleration once in a step") {
  CHECK(measure::evaluations_per_step(euler, drone, frame) == 1);
}

TEST_CASE("Euler loses an undamped spring at every step size") {
  for (const double homega : {0.001, 0.01, 0.1, 1.0}) {
    CHECK(measure::spectral_radius(euler, Spring<>{}, homega) > 1);
    const double growth = std::pow(1 + homega * homega, 1000);
    CHECK_THAT(size_after(2000, Spring<>{.omega = 20}, homega / 20),
               WithinRel(std::sqrt(2) * growth, 1e-6));
  }
}

TEST_CASE("Euler holds a damped spring while h omega is less than two zeta") {
  for (const double zeta : {0.1, 0.5, 0.9, 1.0}) {
    CHECK(size_after(20'000, {.omega = 20, .zeta = zeta}, 0.99 * 2 * zeta / 20) < 0.2);
  }
}

TEST_CASE("Euler loses a damped spring when h omega is more than two zeta") {
  for (const double zeta : {0.1, 0.5, 0.9, 1.0}) {
    CHECK(size_after(20'000, {.omega = 20, .zeta = zeta}, 1.01 * 2 * zeta / 20) > 5);
  }
}

TEST_CASE("An overdamped spring is limited by its fast rate alone") {
  for (const double zeta : {1.5, 2.0, 5.0}) {
    const double fast = 20 * (zeta + std::sqrt(zeta * zeta - 1));
    const Spring<> spring{.omega = 20, .zeta = zeta};
    CHECK_THAT(measure::stability_limit(euler, spring, 1e-6, 1), WithinRel(2 / fast, 1e-9));
    CHECK(size_after(20'000, spring, 0.99 * 2 / fast) < 0.2);
    CHECK(size_after(20'000, spring, 1.01 * 2 / fast) > 5);
  }
}

TEST_CASE("Twice the damping above critical halves the step that Euler can take, or worse") {
  double before = measure::stability_limit(euler, Spring<>{.zeta = 1}, 1e-6, 10);
  for (const double zeta : {2.0, 4.0, 8.0}) {
    const double limit = measure::stability_limit(euler, Spring<>{.zeta = zeta}, 1e-6, 10);
    CHECK(limit < 0.5 * before);
    before = limit;
  }
}

TEST_CASE("Less damping than critical leaves Euler a shorter step") {
  double before = 0;
  for (const double zeta : {0.05, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0}) {
    const double limit = measure::stability_limit(euler, Spring<>{.zeta = zeta}, 1e-6, 10);
    CHECK_THAT(limit, WithinRel(2 * zeta, 1e-6));
    CHECK(limit > before);
    before = limit;
  }
}

TEST_CASE("Below c h = 1 Euler brakes without turning round") {
  for (long n = 1; n <= 20; ++n) {
    CHECK(speed_after(0.5, n) > 0);
    CHECK(speed_after(0.5, n) < speed_after(0.5, n - 1));
  }
}

TEST_CASE("Between c h = 1 and 2 Euler's brakes throw the thing back and forth, less each time") {
  for (long n = 1; n <= 20; ++n) {
    CHECK(speed_after(1.5, n) * speed_after(1.5, n - 1) < 0);
    CHECK(std::abs(speed_after(1.5, n)) < std::abs(speed_after(1.5, n - 1)));
  }
}

TEST_CASE("Above c h = 2 Euler's brakes speed the thing up") {
  CHECK(std::abs(speed_after(1.99, 500)) < 0.1);
  CHECK(std::abs(speed_after(2.01, 500)) > 1000);
}

TEST_CASE("Euler's terminal speed in linear drag is right to rounding") {
  for (const double step : {frame, 0.1, 0.5, 0.9}) {
    CHECK_THAT(-measure::after(euler, leaf, leaf.start(), step, 2000).v,
               WithinRel(leaf.terminal_speed(), 1e-12));
  }
}

TEST_CASE("At ten steps a second a parachute that opens too fast throws its diver upwards") {
  double x = 0, v = diving;
  integrate::euler(x, v, 0.0, 0.1, parachute);
  CHECK(v > 40);
  x = 0, v = diving;
  integrate::euler(x, v, 0.0, frame, parachute);
  CHECK(v < 0);
}

TEST_CASE(
    "Near its final speed Euler settles in drag that grows with the square while k v h is less "
    "than one") {
  const double terminal = parachute.terminal_speed();
  const auto speed_error = [&](double kvh, long steps) {
    double x = 0, v = -0.99 * terminal;
    const double step = kvh / (parachute.k * terminal);
    for (long n = 0; n < steps; ++n) integrate::euler(x, v, 0.0, step, parachute);
    return std::abs(v / terminal + 1);
  };
  CHECK(speed_error(0.98, 5000) < 1e-12);
  for (const long steps : {5000, 5001})
    CHECK(speed_error(1.02, steps) > 0.05);  // between two speeds
}

TEST_CASE("Under a constant force Euler's velocity is exact") {
  for (const double step : {frame, 0.1, 1.0}) {
    const auto end = measure::after(euler, running_jump, running_jump.start(), step, 100);
    CHECK((end.v - running_jump.exact(100 * step).v).norm() < 1e-12 * end.v.norm());
  }
}

TEST_CASE("Under a constant force Euler's position is off by a h t / 2") {
  for (const double step : {frame, 0.1, 1.0}) {
    const double t = 100 * step;
    const auto end = measure::after(euler, running_jump, running_jump.start(), step, 100);
    CHECK_THAT(end.x.y() - running_jump.exact(t).x.y(), WithinRel(9.81 * step * t / 2, 1e-9));
    CHECK_THAT(end.x.x(), WithinRel(running_jump.exact(t).x.x(), 1e-12));
  }
}

TEST_CASE("The exact steps of a spring and of a brake have no limit") {
  for (const double step : {0.01, 0.1, 1.0, 10.0}) {
    // The door with the strongest closer of the table, and a spring that swings.
    for (const Spring<>& spring : {Spring<>{.omega = 80, .zeta = 40}, Spring<>{.zeta = 0.1}}) {
      CHECK(measure::spectral_radius(measure::spring_exact, spring, step) < 1);
    }
    double x = 0, v = 10;
    for (int n = 1; n <= 20; ++n) {
      x += v * (1 - std::exp(-braking.c * step)) / braking.c;
      v *= std::exp(-braking.c * step);
      CHECK_THAT(x, WithinRel(braking.exact(n * step).x, 1e-12));
      CHECK_THAT(v, WithinRel(braking.exact(n * step).v, 1e-12));
    }
  }
  CHECK(measure::spectral_radius(euler, Spring<>{.omega = 80, .zeta = 40}, 0.01) > 1);
}

TEST_CASE("Within a centimetre for a turn of the drone Euler takes 2470 steps a second") {
  const auto error = [](long steps) {
    return measure::largest_error(euler, drone, 8.0 / double(steps), steps).position;
  };
  CHECK(error(8 * 2475) < 0.01);
  for (long rate = 100; rate < 2465; rate += 5) CHECK(error(8 * rate) > 0.01);
}

TEST_CASE("Under Coulomb friction Euler never comes to rest but trembles") {
  const scenes::Friction<> puck;
  auto s = puck.start();
  int turns = 0;
  double before = s.v;
  measure::run(euler, puck, s, frame, 2000, [&](double t, const auto& now) {
    if (t > 20) turns += now.v * before < 0;
    before = now.v;
  });
  CHECK(turns > 700);
}

TEST_CASE(
    "Ten-day steps of Euler lift the energy of the planets two thirds of the way to freedom") {
  const auto start = outer_planets.start();
  const auto end = after_ten_day_steps(start);
  CHECK_THAT(outer_planets.energy(end.x, end.v) / outer_planets.energy(start.x, start.v),
             WithinAbs(0.34, 0.02));
}

TEST_CASE("Ten-day steps of Euler carry Jupiter past the orbit of Saturn") {
  const auto start = outer_planets.start();
  CHECK(apart(after_ten_day_steps(start), 0, 1) > apart(start, 0, 2));
}

TEST_CASE("Ten-day steps of Euler throw Saturn past the orbit of Neptune") {
  const auto start = outer_planets.start();
  CHECK(apart(after_ten_day_steps(start), 0, 2) > 1.1 * apart(start, 0, 4));
}

TEST_CASE(
    "Ten-day steps of Euler leave the outer three near their orbits and 8 to 32 AU off their "
    "places") {
  auto s = outer_planets.start(), truth = s;
  double farthest[Planets::bodies] = {}, true_farthest[Planets::bodies] = {};
  for (long n = 0; n < planet_steps; ++n) {
    euler(s.x, s.v, 0.0, days, outer_planets);
    // Velocity Verlet in steps of a day, written out: the program's truth comes from RK4.
    for (int day = 0; day < days; ++day) {
      truth.v += 0.5 * outer_planets(truth.x, truth.v, 0.0);
      truth.x += truth.v;
      truth.v += 0.5 * outer_planets(truth.x, truth.v, 0.0);
    }
    for (int body = 3; body < Planets::bodies; ++body) {
      farthest[body] = std::max(farthest[body], apart(s, 0, body));
      true_farthest[body] = std::max(true_farthest[body], apart(truth, 0, body));
    }
  }
  CHECK_THAT(misplaced(s, truth, 3), WithinAbs(32.2, 0.1));
  CHECK_THAT(misplaced(s, truth, 4), WithinAbs(19.6, 0.1));
  CHECK_THAT(misplaced(s, truth, 5), WithinAbs(7.6, 0.1));
  for (int body = 3; body < Planets::bodies; ++body) {
    CHECK(farthest[body] > 0.99 * true_farthest[body]);
    CHECK(farthest[body] < 1.2 * true_farthest[body]);
  }
}

TEST_CASE("With two lines swapped the drone stays within four centimetres of its circle") {
  auto s = drone.start();
  measure::run(measure::symplectic_euler, drone, s, frame, 4800,
               [](double, const auto& now) { CHECK_THAT(now.x.norm(), WithinAbs(10, 0.04)); });
}

TEST_CASE("A camera spring of 12 per second needs 20 steps a second at zeta 0.3 and 35 at zeta 3") {
  const auto rate = [](double zeta) {
    return 1 / measure::stability_limit(euler, Spring<>{.omega = 12, .zeta = zeta}, 1e-6, 1);
  };
  CHECK_THAT(rate(0.3), WithinRel(20, 1e-9));
  CHECK_THAT(rate(3), WithinAbs(35, 0.1));
}

TEST_CASE("A turn forward and a turn back leave the drone on its line, 10.86 m out") {
  auto s = measure::after(euler, drone, drone.start(), frame, turn);
  s = measure::after(euler, drone, s, -frame, turn);
  CHECK_THAT(s.x.x(), WithinAbs(10.86, 0.005));
  CHECK_THAT(s.x.y(), WithinAbs(0, 1e-9));
}

TEST_CASE(
    "A spring with a damping ratio of 1 overshoots if it comes in faster than omega x, and only "
    "then") {
  const auto least = [](const Spring<>& spring) {
    double lowest = spring.x0;
    for (int n = 1; n <= 20'000; ++n) lowest = std::min(lowest, spring.exact(n / 1000.0).x);
    return lowest;
  };
  for (const double omega : {0.5, 2.0, 8.0}) {
    for (const double part : {0.0, 0.5, 0.99, 1.2, 1.5, 2.5}) {
      CAPTURE(omega, part);
      const double lowest = least({.omega = omega, .zeta = 1, .v0 = -part * omega});
      if (part < 1) {
        CHECK(lowest > 0);
      } else {
        // x = (1 - (part - 1) omega t) exp(-omega t), the lowest at omega t = part / (part - 1).
        const double expected = -(part - 1) * std::exp(-part / (part - 1));
        CHECK_THAT(lowest, WithinRel(expected, 1e-3));
      }
    }
  }
  CHECK_THAT(least({.omega = 8, .zeta = 1, .v0 = -20}), WithinAbs(-0.283, 5e-4));
}

TEST_CASE("Each step of Euler multiplies the area of a blob of starts by the determinant") {
  for (const double step : {0.002, 0.005, 0.015, 0.05}) {
    const double homega = step * suspension.omega;
    const double determinant = 1 - 2 * suspension.zeta * homega + homega * homega;
    for (const long steps : {1L, 20L}) {
      // A lopsided blob as well, far from the place of rest.
      for (Blob blob : {round_blob(), Blob{{1, 2}, {3, 1}, {2, 5}, {0, 4}}}) {
        CHECK_THAT(area(stepped(blob, step, steps)) / area(blob),
                   WithinRel(std::pow(determinant, double(steps)), 1e-9));
      }
    }
  }
}

TEST_CASE("After one swing a blob has 0.53 of its area in steps of 5 ms, 1.86 in steps of 15 ms") {
  const double before = area(round_blob());
  CHECK_THAT(area(stepped(round_blob(), 0.005, 63)) / before, WithinAbs(0.531, 0.001));
  CHECK_THAT(area(stepped(round_blob(), 0.015, 21)) / before, WithinAbs(1.860, 0.001));
  const auto swing = [](double x, double v) {
    return Spring<>{.omega = 20, .zeta = 0.1, .x0 = x, .v0 = v}.exact(0.3158);
  };
  const auto right = swing(1, 0), up = swing(0, 1);
  CHECK_THAT(right.x * up.v - up.x * right.v, WithinAbs(0.283, 0.001));
}

TEST_CASE("After a hitch Euler's camera flies more than a metre past its target") {
  double farthest = 0, exact_farthest = 0;
  hitch(60, [&](const Hitch& now) {
    farthest = std::max(farthest, now.euler);
    exact_farthest = std::max(exact_farthest, now.exact);
    // The exact camera is where a camera without frames would be.
    const double left = (1 + camera.omega * now.t) * std::exp(-camera.omega * now.t);
    CHECK_THAT(now.exact, WithinAbs(1 - left, 1e-12));
  });
  CHECK_THAT(farthest, WithinAbs(2.22, 0.01));
  CHECK(exact_farthest < 1 + 1e-12);
}

/// How far a camera is behind the drone after a turn, if in each frame it goes a share of the way.
double behind_the_drone(int rate, double share) {
  const auto place = [&](int n) { return drone.exact(double(n) / rate).x; };
  auto view = place(0);
  for (int n = 1; n <= 8 * rate; ++n) view += share * (place(n) - view);
  return (place(8 * rate) - view).norm();
}

TEST_CASE(
    "At 20 Hz lerp is nearly three times as far behind the drone as at 60, the exact step about as "
    "far") {
  const double c = -60 * std::log(0.9), fast = behind_the_drone(60, 0.1);
  CHECK_THAT(behind_the_drone(20, 0.1) / fast, WithinAbs(2.8, 0.1));
  CHECK_THAT(behind_the_drone(20, 1 - std::exp(-c / 20)) / fast, WithinAbs(0.9, 0.02));
}

TEST_CASE(
    "A tenth of the way in every frame is another motion at every frame rate, smoothing one") {
  CHECK_THAT(left_by_lerp(30), WithinAbs(2.06, 0.01));
  CHECK_THAT(left_by_lerp(144), WithinAbs(0.005, 0.0005));
  for (const int rate : {30, 60, 144}) {
    double x = 0;
    for (int n = 0; n < rate / 2; ++n) shelf::smooth(x, 10.0, 0.0, -60 * std::log(0.9), 1.0 / rate);
    CHECK_THAT(10 - x, WithinRel(left_by_lerp(60), 1e-12));
  }
}

TEST_CASE("After a late frame smoothing is where it would have been, and lerp far behind") {
  for (const long late : {1L, 6L, 15L}) {
    after_a_jump(60, late, [&](const Machine<double>& machine) {
      const double t = double(machine.shown) / 60;
      CHECK_THAT(10 - machine.exact, WithinAbs(10 * std::exp(-tuned * t), 1e-12));
      // Of the refreshes since the jump lerp has seen one where the late frame took more.
      const double seen = double(machine.shown > 6 ? machine.shown - late + 1 : machine.shown);
      CHECK_THAT(10 - machine.lerp, WithinAbs(10 * std::pow(0.9, seen), 1e-12));
    });
  }
  CHECK(std::pow(0.9, 30 - 15 + 1) > 4 * std::pow(0.9, 30));
}

TEST_CASE("A damper of c = h omega^2 takes what Euler's method gives, and the drone stays") {
  const double c = frame * drone.omega * drone.omega;
  const auto in_air = [&](const auto& x, const auto& v, double t) {
    return scenes::Circle<>::Vec(drone(x, v, t) - c * v);
  };
  auto s = drone.start(), truth = s;
  measure::run(euler, in_air, s, frame, 10 * turn,
               [](double, const auto& now) { CHECK_THAT(now.x.norm(), WithinAbs(10, 0.08)); });
  truth = measure::after(measure::rk4, in_air, truth, frame, 10 * turn);
  CHECK_THAT(truth.x.norm(), WithinAbs(6.63, 0.01));
}
