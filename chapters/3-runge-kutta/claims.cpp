// SPDX-License-Identifier: MIT-0
// The claims of chapter 3. Each name is a sentence that the chapter says.
#include <Eigen/LU>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "blend.h"
#include "burn_areas.h"
#include "burnout.h"
#include "comet.h"
#include "equal_cost.h"
#include "measure/energy.h"
#include "measure/error.h"
#include "measure/evaluations.h"
#include "measure/many_starts.h"
#include "measure/methods.h"
#include "measure/order.h"
#include "measure/stability.h"
#include "measure/times.h"
#include "rest.h"
#include "rk4_energy.h"
#include "single.h"
#include "stability_limits.h"
#include "toys.h"
#include "wrong.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using measure::euler;
using measure::midpoint;
using measure::rk4;
using scenes::Spring;
using scenes::State;
using wrong::old_velocity;

namespace {

const auto drone_energy = [](const auto& x, const auto& v) { return drone.energy(x, v); };

double distance_after_ten_turns(auto step, double step_size) {
  return measure::after(step, drone, drone.start(), step_size, std::lround(80 / step_size))
      .x.norm();
}

double error_in_one_turn(auto step, double rate) {
  return measure::largest_error(step, drone, 1 / rate, std::lround(8 * rate)).position;
}

double energy_factor(auto step, double homega) {
  return std::pow(measure::spectral_radius(step, Spring<>{}, homega), 2);
}

/// The size of an undamped spring's state after many steps.
double size_after(auto step, long steps, double homega) {
  const auto end = measure::after(step, Spring<>{}, State<double>{1, 1}, homega, steps);
  return std::hypot(end.x, end.v);
}

double order_in_position(auto step, const auto& scene, double coarse, double duration) {
  return measure::halvings(step, scene, coarse, duration, 4).back().position_order;
}

void check_order(auto step, const auto& scene, double coarse, double duration, double order) {
  const auto study = measure::halvings(step, scene, coarse, duration, 5);
  for (std::size_t i = study.size() - 2; i < study.size(); ++i) {
    CHECK_THAT(study[i].position_order, WithinAbs(order, 0.1));
    CHECK_THAT(study[i].velocity_order, WithinAbs(order, 0.1));
  }
}

/// The four slopes of one long RK4 step of braking, x'' = -x', from the velocity 1, with their sign
/// turned.
std::vector<double> braking_slopes(double ch) {
  std::vector<double> slopes;
  double x = 0, v = 1;
  integrate::rk4(x, v, 0.0, ch, [&](double, double velocity, double) {
    slopes.push_back(velocity);
    return -velocity;
  });
  return slopes;
}

/// How far off a method is at most in six seconds, at so many steps a second.
double off_across(bool by_rk4, int rate) {
  double x = 0, v = 0, most = 0;
  for (int n = 0; n < 6 * rate; ++n) {
    if (by_rk4) {
      integrate::rk4(x, v, double(n) / rate, 1.0 / rate, off_beat_rocket);
    } else {
      integrate::euler(x, v, double(n) / rate, 1.0 / rate, off_beat_rocket);
    }
    most = std::max(most, std::abs(x - off_beat_rocket.exact(double(n + 1) / rate).x));
  }
  return most;
}

}  // namespace

TEST_CASE(
    "At ten evaluations a second RK4 ends two turns a centimetre off, midpoint half a metre and "
    "Euler six") {
  const auto end_error = [](auto step, double rate) {
    const auto end = measure::after(step, drone, drone.start(), 1 / rate, std::lround(16 * rate));
    return (end.x - drone.exact(16).x).norm();
  };
  CHECK_THAT(end_error(rk4, 2.5), WithinAbs(0.0102, 1e-4));
  CHECK_THAT(end_error(midpoint, 5), WithinAbs(0.518, 0.001));
  CHECK_THAT(end_error(euler, 10), WithinAbs(6.36, 0.01));
}

TEST_CASE("A midpoint step that moves with the old velocity has order one") {
  check_order(old_velocity, drone, 1.0 / 30, 8, 1);
  CHECK_THAT(order_in_position(old_velocity, parachute, 1.0 / 64, 2), WithinAbs(1, 0.1));
}

TEST_CASE("Moving with the old velocity gains half as much energy in a step as Euler does") {
  for (const double homega : {0.01, 0.1, 0.5, 1.0}) {
    const double gain = energy_factor(old_velocity, homega) - 1;
    CHECK_THAT(gain, WithinRel(homega * homega / 2, 1e-9));
    CHECK_THAT(energy_factor(euler, homega) - 1, WithinRel(2 * gain, 1e-9));
  }
}

TEST_CASE("Moving with the old velocity, 60 steps a second go where 120 of Euler go") {
  const double wrong = distance_after_ten_turns(old_velocity, frame);
  CHECK_THAT(distance_after_ten_turns(euler, frame / 2), WithinAbs(wrong, 0.001));
  CHECK(wrong > 12);
}

TEST_CASE("Looking halfway with the old velocity more than halves the drift of ten turns") {
  const auto drift = [](auto step) { return distance_after_ten_turns(step, frame) - drone.radius; };
  CHECK(drift(old_velocity) < 0.5 * drift(euler));
  CHECK(drift(old_velocity) > 0.4 * drift(euler));
}

TEST_CASE("A midpoint step of a second ends almost four times nearer to the drone than Euler's") {
  const auto end_error = [](auto step) {
    const auto end = measure::after(step, drone, drone.start(), 1.0, 1);
    return (end.x - drone.exact(1.0).x).norm();
  };
  CHECK_THAT(end_error(euler) / end_error(midpoint), WithinAbs(3.8, 0.05));
}

TEST_CASE("The midpoint method keeps the drone within a millimetre of its circle for ten turns") {
  auto s = drone.start();
  measure::run(midpoint, drone, s, frame, 10 * turn,
               [](double, const auto& now) { CHECK_THAT(now.x.norm(), WithinAbs(10, 0.001)); });
}

TEST_CASE("After ten turns the midpoint drone is out by a hundredth of what it is ahead") {
  const auto end = measure::after(midpoint, drone, drone.start(), frame, 10 * turn);
  const double ahead = 10 * std::atan2(end.x.y(), end.x.x());
  CHECK_THAT(ahead, WithinAbs(0.0179, 0.0002));
  CHECK_THAT((end.x.norm() - 10) / ahead, WithinAbs(0.01, 0.001));
  CHECK_THAT(measure::largest_error(midpoint, drone, frame, 10 * turn).position,
             WithinRel(ahead, 0.01));
}

TEST_CASE("The midpoint method has order two on a circle, an ellipse, a parachute and a rocket") {
  check_order(midpoint, drone, 1.0 / 16, 8, 2);
  check_order(midpoint, ellipse, 1.0 / 256, 4, 2);
  check_order(midpoint, parachute, 1.0 / 64, 2, 2);
  check_order(midpoint, engine_on, 1.0 / 8, 3.5, 2);
}

TEST_CASE(
    "One turn in steps of 10 ms ends 2.5 per cent out with the old velocity, not with the new") {
  const scenes::Circle<> demo{.omega = 2 * std::numbers::pi / 4};
  const auto radius = [&](auto step) {
    return measure::after(step, demo, demo.start(), 0.01, 400).x.norm();
  };
  CHECK_THAT(radius(old_velocity), WithinAbs(1.025, 5e-4));
  CHECK_THAT(radius(midpoint), WithinAbs(1.000003, 5e-7));
}

TEST_CASE("For a push that depends on time alone, RK4's velocity is right up to the third power") {
  for (int power = 0; power <= 4; ++power) {
    double x = 0, v = 0;
    integrate::rk4(x, v, 0.0, 2.0, [&](double, double, double t) { return std::pow(t, power); });
    const double truth = std::pow(2.0, power + 1) / (power + 1);
    if (power <= 3) {
      CHECK_THAT(v, WithinRel(truth, 1e-14));
    } else {
      CHECK(std::abs(v / truth - 1) > 0.01);
    }
  }
}

TEST_CASE("In a braking step the second slope is too small, the third too large by a little more") {
  for (const double ch : {1.0, 0.1, 0.01}) {
    const auto slopes = braking_slopes(ch);
    const double second = slopes[1] - std::exp(-ch / 2), third = slopes[2] - std::exp(-ch / 2);
    CHECK(second < 0);
    CHECK(third > -second);
    CHECK((second + third) / 2 < 0.18 * ch * -second);
  }
}

TEST_CASE("Only the weights 1, 2, 2, 1 match braking up to the fourth power of the step") {
  // Row p holds what the four slopes contribute to (ch)^p; on the right are the sums of e^z.
  Eigen::Matrix4d powers;
  powers << 1, 1, 1, 1, 0, 0.5, 0.5, 1, 0, 0, 0.25, 0.5, 0, 0, 0, 0.25;
  for (const double z : {-0.5, 1.0}) {
    const auto slopes = braking_slopes(-z);
    const Eigen::RowVector4d steps = Eigen::RowVector4d(1, z, z * z, z * z * z) * powers;
    for (int i = 0; i < 4; ++i) {
      CHECK_THAT(slopes[std::size_t(i)], WithinRel(steps[i], 1e-14));
    }
  }
  CHECK(std::abs(powers.determinant()) > 0.01);
  const Eigen::Vector4d weights = powers.lu().solve(Eigen::Vector4d(1, 1. / 2, 1. / 6, 1. / 24));
  CHECK((weights - Eigen::Vector4d(1, 2, 2, 1) / 6).norm() < 1e-14);
}

TEST_CASE("What a step adds to a rocket's velocity is the area under what it takes for the push") {
  double areas[3] = {}, truth = 0;  // under the midpoint of a thousand strips each
  const int strips = 1000;
  for (int n = 0; n < strips; ++n) {
    const double t = burn * (n + 0.5) / strips, width = burn / strips;
    areas[0] += push(0) * width;
    areas[1] += push(burn / 2) * width;
    areas[2] += simpson_parabola(t) * width;
    truth += push(t) * width;
  }
  CHECK_THAT(velocity_after_burn(euler), WithinRel(areas[0], 1e-5));
  CHECK_THAT(velocity_after_burn(midpoint), WithinRel(areas[1], 1e-5));
  CHECK_THAT(velocity_after_burn(rk4), WithinRel(areas[2], 1e-5));
  CHECK_THAT(engine_on.exact(burn).v, WithinRel(truth, 1e-5));
}

TEST_CASE("RK4 meets all eight conditions of order four") {
  const wrong::Stages rk;
  double sums[8] = {};
  for (int i = 0; i < 4; ++i) {
    const double b = rk.weight[i], c = rk.reach[i];
    const int j = rk.velocity_from[i], k = rk.velocity_from[j];
    const double through = i == 0 ? 0 : c, deep = j == 0 ? 0 : rk.reach[j];
    const double terms[8] = {1,
                             c,
                             c * c,
                             through * rk.reach[j],
                             c * c * c,
                             c * through * rk.reach[j],
                             through * rk.reach[j] * rk.reach[j],
                             through * deep * rk.reach[k]};
    for (int n = 0; n < 8; ++n) sums[n] += b * terms[n];
  }
  const double wanted[8] = {1, 1. / 2, 1. / 3, 1. / 6, 1. / 4, 1. / 8, 1. / 12, 1. / 24};
  for (int n = 0; n < 8; ++n) CHECK_THAT(sums[n], WithinAbs(wanted[n], 1e-14));
  auto s = ellipse.start(), same = s;
  for (int n = 0; n < 50; ++n) {
    integrate::rk4(s.x, s.v, n * frame, frame, ellipse);
    wrong::step_by(rk, same.x, same.v, n * frame, frame, ellipse);
  }
  CHECK((s.x - same.x).norm() < 1e-11);
}

TEST_CASE("RK4 has order four on a circle, an ellipse, a parachute and a rocket") {
  check_order(rk4, drone, 1.0 / 2, 8, 4);
  check_order(rk4, ellipse, 1.0 / 64, 4, 4);
  check_order(rk4, parachute, 1.0 / 64, 2, 4);
  check_order(rk4, engine_on, 1.0 / 2, 3.5, 4);
}

TEST_CASE("A step asks for the acceleration twice with midpoint and four times with RK4") {
  CHECK(measure::evaluations_per_step(midpoint, drone, frame) == 2);
  CHECK(measure::evaluations_per_step(rk4, drone, frame) == 4);
}

TEST_CASE("In steps of a second RK4 keeps the drone within 13 cm of its circle for a turn") {
  auto s = drone.start();
  measure::run(rk4, drone, s, 1.0, 8,
               [](double, const auto& now) { CHECK_THAT(now.x.norm(), WithinAbs(10, 0.13)); });
  CHECK(s.x.norm() < 9.9);
}

TEST_CASE("On 240 evaluations a second midpoint is 200 times nearer than Euler, RK4 20 000 again") {
  const double one = error_in_one_turn(euler, 240);
  const double two = error_in_one_turn(midpoint, 120);
  const double four = error_in_one_turn(rk4, 60);
  CHECK(one / two > 200);
  CHECK(one / two < 300);
  CHECK(two / four > 20'000);
  CHECK(two / four < 40'000);
}

TEST_CASE(
    "On sixteen evaluations a second RK4 keeps the circle to a centimetre, and nobody the "
    "ellipse") {
  const auto position_error = [](auto step, const auto& scene) {
    const double rate = price / double(measure::evaluations_per_step(step, scene, frame));
    return measure::largest_error(step, scene, 1 / rate, std::lround(time_for_them * rate))
        .position;
  };
  CHECK(position_error(rk4, drone) < 0.01);
  CHECK(position_error(midpoint, drone) > 0.1);
  CHECK(position_error(measure::symplectic_euler, drone) > 0.1);
  CHECK(position_error(euler, drone) > 1);
  CHECK(position_error(rk4, ellipse) > 1);
  CHECK(position_error(midpoint, ellipse) > 1);
  CHECK(position_error(measure::symplectic_euler, ellipse) > 1);
  CHECK(position_error(euler, ellipse) > 1);
}

TEST_CASE(
    "In ten turns at four evaluations a second symplectic Euler is off by at most a tenth more "
    "than RK4") {
  const double by_rk4 = measure::largest_error(rk4, drone, 1.0, 80).position;
  const double by_swap =
      measure::largest_error(measure::symplectic_euler, drone, 0.25, 320).position;
  CHECK(by_swap > by_rk4);
  CHECK(by_swap < 1.1 * by_rk4);
}

TEST_CASE("Across the end of a burn RK4 has order one") {
  // The error depends on where in its step the engine stops; the worst of many rates does not.
  const auto worst = [](double rate) {
    double largest = 0;
    for (double r = rate; r < 2 * rate; ++r) largest = std::max(largest, burnout_errors(r)[0]);
    return largest;
  };
  for (const double rate : {80.0, 160.0, 320.0}) {
    CHECK_THAT(std::log2(worst(rate) / worst(2 * rate)), WithinAbs(1, 0.2));
  }
}

TEST_CASE("Where a rope goes taut RK4 has order two") {
  constexpr double omega = 20;
  const auto rope = [](double x, double, double) { return -omega * omega * std::max(0.0, x); };
  // Thrown at 1 m/s from 20 cm before it is taut, and somewhat less far; the worst after 0.25 s.
  const auto worst = [&](long steps) {
    double most = 0;
    for (int n = 0; n < 100; ++n) {
      const double start = -0.2 + 0.05 * n / 100;
      const double truth = std::sin(omega * (0.25 + start)) / omega;
      const auto end = measure::after(measure::rk4, rope, scenes::State<double>{start, 1},
                                      0.25 / double(steps), steps);
      most = std::max(most, std::abs(end.x - truth));
    }
    return most;
  };
  for (const long steps : {16, 32, 64, 128})
    CHECK_THAT(std::log2(worst(steps) / worst(2 * steps)), WithinAbs(2, 0.15));
}

TEST_CASE("Across a burnout RK4 is nearer than Euler in as many steps") {
  CHECK_THAT(off_across(true, 60), WithinAbs(0.268, 0.001));
  CHECK_THAT(off_across(false, 60), WithinAbs(0.61, 0.005));
  for (int rate = 20; rate <= 240; ++rate) CHECK(off_across(true, rate) < off_across(false, rate));
}

TEST_CASE("Across a burnout Euler is nearer than RK4 at half of all prices") {
  int nearer = 0;
  for (int rate = 20; rate <= 240; ++rate)
    nearer += off_across(false, 4 * rate) < off_across(true, rate);
  CHECK_THAT(nearer / 221.0, WithinAbs(0.5, 0.02));
}

TEST_CASE("A step cut where the engine stops gives RK4 its fourth order back") {
  for (const double rate : {8.0, 16.0, 32.0}) {
    CHECK_THAT(std::log2(burnout_errors(rate)[1] / burnout_errors(2 * rate)[1]), WithinAbs(4, 0.1));
  }
}

TEST_CASE("Every step of an undamped spring multiplies the energy by what the formulas say") {
  for (const double z : {0.1, 0.5, 1.0, 2.0, 2.8, 3.0}) {
    const Spring<> spring{.omega = 5, .x0 = 0.3, .v0 = 2};
    const auto energy = [&](double x, double v) { return spring.energy(x, v); };
    const auto factor = [&](auto step) {
      return 1 + measure::drift(step, spring, z / 5, 1, energy).last;
    };
    CHECK_THAT(factor(midpoint), WithinRel(1 + std::pow(z, 4) / 4, 1e-12));
    CHECK_THAT(factor(rk4), WithinRel(1 - std::pow(z, 6) / 72 + std::pow(z, 8) / 576, 1e-12));
  }
}

TEST_CASE("In a day RK4 takes less than a millionth of the drone's energy") {
  const double lost = -measure::drift(rk4, drone, frame, 24L * 3600 * 60, drone_energy).last;
  CHECK_THAT(lost, WithinRel(24 * 3600 * 60 * std::pow(frame * drone.omega, 6) / 72, 0.01));
  CHECK(lost < 1e-6);
}

TEST_CASE(
    "With forty steps a swing RK4 takes a fifth of a per cent in a minute of four swings a "
    "second") {
  const auto spring = swinging(4);
  const auto energy = [&](double x, double v) { return spring.energy(x, v); };
  const double lost = -measure::drift(rk4, spring, 1.0 / 160, 160 * 60, energy).last;
  CHECK_THAT(lost, WithinAbs(0.002, 0.0001));
  const double in_an_hour = -measure::drift(rk4, spring, 1.0 / 160, 160 * 3600, energy).last;
  CHECK_THAT(in_an_hour, WithinAbs(0.113, 0.001));
}

TEST_CASE("In a float rounding changes the drone's energy in a day by more than RK4 takes") {
  const scenes::Circle<float> single{.omega = float(drone.omega), .radius = 10};
  auto s = single.start();
  for (long n = 0; n < 24L * 3600 * 60; ++n) integrate::rk4(s.x, s.v, 0.0, 1.0f / 60, single);
  const auto energy_of = [&](const auto& state) {
    return drone.energy(state.x.template cast<double>(), state.v.template cast<double>());
  };
  CHECK(std::abs(energy_of(s) / energy_of(single.start()) - 1) > 2e-6);
}

TEST_CASE("In one minute at 60 Hz RK4 takes a quarter of the energy at four swings a second") {
  CHECK_THAT(left_after(3600, frame * swinging(4).omega), WithinAbs(0.77, 0.005));
  CHECK(left_after(3600, frame * swinging(8).omega) < 1e-4);
}

TEST_CASE("In one minute RK4 takes half a per cent from two swings a second, and all from eight") {
  CHECK_THAT(left_after(3600, frame * swinging(2).omega), WithinAbs(0.9955, 0.0005));
  CHECK(left_after(3600, frame * swinging(8).omega) < 1e-6);
}

TEST_CASE("The line of one per cent a minute at 60 Hz lies at 26 steps a swing") {
  CHECK(left_after(3600, 2 * std::numbers::pi / 26.5) > 0.99);
  CHECK(left_after(3600, 2 * std::numbers::pi / 25.5) < 0.99);
}

TEST_CASE("Twice the steps per swing make RK4's loss in a swing 32 times smaller") {
  const auto lost = [](long steps) {
    return 1 - left_after(steps, 2 * std::numbers::pi / double(steps));
  };
  CHECK_THAT(lost(20) / lost(40), WithinRel(32, 0.02));
  CHECK_THAT(lost(40) / lost(80), WithinRel(32, 0.02));
}

TEST_CASE("RK4 takes energy from a pendulum and from an ellipse, too") {
  const scenes::Pendulum<> pendulum{.angle = 2};
  const auto swing = [&](double x, double v) { return pendulum.energy(x, v); };
  const auto orbit = [](const auto& x, const auto& v) { return ellipse.energy(x, v); };
  for (const long rate : {20, 60}) {
    const double of_pendulum =
        measure::drift(rk4, pendulum, 1.0 / double(rate), 60 * rate, swing).last;
    CHECK(of_pendulum < 0);
    CHECK(of_pendulum > -0.01);
    const double of_ellipse =
        measure::drift(rk4, ellipse, 1.0 / double(rate), 60 * rate, orbit).last;
    CHECK(of_ellipse < 0);
    CHECK(of_ellipse > -0.01);
  }
}

TEST_CASE("With 30 steps a turn RK4 throws the drone off its ellipse for good") {
  const auto energy_after_30_turns = [](long steps) {
    const auto end = measure::after(rk4, ellipse, ellipse.start(), 8.0 / double(steps), 30 * steps);
    return ellipse.energy(end.x, end.v);
  };
  CHECK(energy_after_30_turns(60) < 0);
  CHECK(energy_after_30_turns(30) > 0);
}

TEST_CASE(
    "At 20 steps a second RK4 follows a suspension closer than midpoint at 40 or Euler at 80") {
  const auto error = [](auto step, int rate) {
    return measure::largest_error(step, suspension, 1.0 / rate, rate).position;
  };
  CHECK(error(rk4, 20) < 0.0031);
  CHECK(error(midpoint, 40) > 4 * error(rk4, 20));
  CHECK(error(euler, 80) > 40 * error(rk4, 20));
}

TEST_CASE(
    "At 20 steps a second Euler has lost the suspension, and midpoint keeps a seventh of its "
    "damping") {
  CHECK(measure::spectral_radius(euler, suspension, 1.0 / 20) > 1.2);
  const double damping = suspension.zeta * suspension.omega / 20;
  const double kept = -std::log(measure::spectral_radius(midpoint, suspension, 1.0 / 20)) / damping;
  CHECK_THAT(kept, WithinAbs(1.0 / 7, 0.015));
}

TEST_CASE(
    "At 20 steps a second straight lines between them are three times further off than they") {
  const double off = measure::largest_error(rk4, suspension, 1.0 / 20, 20).position;
  CHECK_THAT(blend_errors(20).line / off, WithinAbs(3.2, 0.2));
}

TEST_CASE("A cubic between two steps is off by hardly more than the steps") {
  const double off = measure::largest_error(rk4, suspension, 1.0 / 20, 20).position;
  CHECK_THAT(blend_errors(20).curve / off, WithinAbs(1.1, 0.1));
}

TEST_CASE("RK4 holds an undamped spring while h omega is less than the root of eight") {
  CHECK(size_after(rk4, 20'000, 0.99 * std::sqrt(8)) < 1e-10);
}

TEST_CASE("RK4 loses an undamped spring when h omega is more than the root of eight") {
  CHECK(size_after(rk4, 200, 1.01 * std::sqrt(8)) > 1e5);
}

TEST_CASE("A step of h omega = root of six leaves a quarter of the energy") {
  CHECK_THAT(energy_factor(rk4, std::sqrt(6)), WithinRel(0.25, 1e-12));
  CHECK(energy_factor(rk4, std::sqrt(6) - 0.05) > 0.2505);
  CHECK(energy_factor(rk4, std::sqrt(6) + 0.05) > 0.2505);
}

TEST_CASE("RK4 brakes while c h is less than 2.785 and speeds up beyond") {
  const scenes::LinearDrag<> braking{.c = 1, .g = 0, .v0 = 1};
  CHECK(std::abs(measure::after(rk4, braking, braking.start(), 2.78, 2000).v) < 1e-5);
  CHECK(std::abs(measure::after(rk4, braking, braking.start(), 2.79, 2000).v) > 1e5);
}

TEST_CASE("Per evaluation symplectic Euler may take a step nearly three times as long as RK4's") {
  const double one = measure::stability_limit(measure::symplectic_euler, Spring<>{}, 0.1, 10);
  const double four = measure::stability_limit(rk4, Spring<>{}, 0.1, 10) / 4;
  CHECK_THAT(one / four, WithinAbs(2.83, 0.01));
}

TEST_CASE("The midpoint method gains energy from every undamped spring") {
  for (const double homega : {0.01, 0.1, 1.0}) CHECK(energy_factor(midpoint, homega) > 1);
  CHECK(size_after(midpoint, 20'000, 0.2) > 10);
}

TEST_CASE("A stiff door takes nearly three times as many evaluations with RK4 as with Euler") {
  const double one = 1 / measure::stability_limit(euler, door, 1e-3, 0.1);
  const double four = 4 / measure::stability_limit(rk4, door, 1e-3, 0.1);
  CHECK_THAT(four / one, WithinAbs(2.87, 0.01));
}

TEST_CASE("The limits found by running are those of the polynomials") {
  for (const double zeta : {0.1, 0.5, 1.0, 2.0}) {
    const Spring<> spring{.zeta = zeta};
    CHECK_THAT(measure::stability_limit(rk4, spring, 1e-6, 10),
               WithinRel(limit_by_polynomial({1, 1, 0.5, 1. / 6, 1. / 24}, zeta), 1e-6));
    CHECK_THAT(measure::stability_limit(midpoint, spring, 1e-6, 10),
               WithinRel(limit_by_polynomial({1, 1, 0.5}, zeta), 1e-6));
  }
}

TEST_CASE("Under a constant force midpoint and RK4 are exact, whatever the step") {
  for (const double step : {frame, 0.1, 1.0}) {
    const auto truth = running_jump.exact(100 * step);
    for (const auto& end : {measure::after(midpoint, running_jump, running_jump.start(), step, 100),
                            measure::after(rk4, running_jump, running_jump.start(), step, 100)}) {
      CHECK((end.x - truth.x).norm() < 1e-12 * truth.x.norm());
      CHECK((end.v - truth.v).norm() < 1e-12 * truth.v.norm());
    }
  }
}

TEST_CASE("RK4's terminal speed in linear drag is right to rounding") {
  for (const double step : {frame, 0.1, 0.5, 1.3}) {
    CHECK_THAT(-measure::after(rk4, leaf, leaf.start(), step, 2000).v,
               WithinRel(leaf.terminal_speed(), 1e-12));
  }
}

TEST_CASE("One matrix takes the steps of RK4 to rounding and never asks for the acceleration") {
  for (const double step : {frame, 0.05}) {
    const auto folded =
        measure::after(measure::rk4_linear, suspension, suspension.start(), step, 60);
    const auto plain = measure::after(rk4, suspension, suspension.start(), step, 60);
    CHECK_THAT(folded.x, WithinAbs(plain.x, 1e-15));
    CHECK_THAT(folded.v, WithinAbs(plain.v, 1e-13));
  }
  CHECK(measure::evaluations_per_step(measure::rk4_linear, suspension, frame) == 0);
}

TEST_CASE("The exact step of a spring folds into four numbers as well") {
  double xx = 1, vx = 0, xv = 0, vv = 1;
  integrate::spring_exact(xx, vx, 0.05, suspension.omega, suspension.zeta);
  integrate::spring_exact(xv, vv, 0.05, suspension.omega, suspension.zeta);
  const auto exact = integrate::spring_folded_start(0.05, suspension.omega, suspension.zeta);
  CHECK(exact.xx == xx);
  CHECK(exact.vx == vx);
  CHECK(exact.xv == xv);
  CHECK(exact.vv == vv);
  double x = suspension.x0, v = suspension.v0;
  for (int n = 0; n < 20; ++n) integrate::spring_folded(x, v, exact);
  CHECK_THAT(x, WithinAbs(suspension.exact(1).x, 1e-14));
  CHECK_THAT(v, WithinAbs(suspension.exact(1).v, 1e-13));
}

TEST_CASE("With its fourth stage along the second slope RK4 has order three and hides it") {
  const auto bug = wrong::method_of(wrong::fourth_looks_too_soon.stages);
  check_order(bug, drone, 1.0 / 2, 8, 3);
  check_order(bug, ellipse, 1.0 / 64, 4, 3);
  CHECK(error_in_one_turn(bug, 60) < 1e-5);
}

TEST_CASE(
    "In a float RK4 is nearest to the drone at 16 to 32 steps a second, by the median of many "
    "starts") {
  const auto median = [](int rate) { return measure::median(errors_in_float(rk4, rate)); };
  CHECK(median(8) < median(4) / 10);
  CHECK(median(16) < median(8) / 8);
  CHECK_THAT(median(32) / median(16), WithinAbs(1.3, 0.2));
  CHECK(median(64) > 1.2 * median(32));
  CHECK(median(128) > 1.1 * median(64));
  CHECK(median(256) > 1.3 * median(128));
  // In double the same runs go on falling.
  CHECK(error_in_one_turn(rk4, 128) < 1e-3 * error_in_one_turn(rk4, 16));
}

TEST_CASE(
    "In a float one start in ten leaves RK4 more than twice as far off as another one in ten") {
  for (const int rate : {16, 32, 128}) {
    const auto errors = errors_in_float(rk4, rate);
    CHECK(measure::quantile(errors, 0.9) > 2 * measure::quantile(errors, 0.1));
  }
}

TEST_CASE(
    "In a float the right RK4 shows an order below one from nine starts in ten, the wrong index "
    "above two from all") {
  const auto right = orders_in_float(rk4);
  CHECK(measure::quantile(right, 0.9) < 1);
  CHECK(measure::quantile(right, 0.1) < -1);
  CHECK(orders_in_float(wrong::method_of(wrong::fourth_looks_too_soon.stages)).front() > 2);
}

TEST_CASE("With its third stage a repeat of the second RK4 has order two") {
  const auto bug = wrong::method_of(wrong::third_is_second.stages);
  check_order(bug, drone, 1.0 / 8, 8, 2);
  CHECK(error_in_one_turn(bug, 60) < 1e-3);
}

TEST_CASE("With all slopes counting the same RK4 has order two") {
  const auto bug = wrong::method_of(wrong::equal_weights.stages);
  check_order(bug, drone, 1.0 / 8, 8, 2);
  check_order(bug, parachute, 1.0 / 64, 2, 2);
  check_order(bug, engine_on, 1.0 / 8, 3.5, 2);
  CHECK(error_in_one_turn(bug, 60) < 1e-3);
}

TEST_CASE(
    "With one step a second the wrong index puts the drone a metre off, six times as far as RK4") {
  const double off = error_in_one_turn(wrong::method_of(wrong::fourth_looks_too_soon.stages), 1);
  CHECK_THAT(off, WithinAbs(1.2, 0.05));
  CHECK_THAT(off / error_in_one_turn(rk4, 1), WithinAbs(6.1, 0.1));
}

TEST_CASE("Of the three scenes only the drone finds stages that move with the old velocity") {
  const auto bug = wrong::method_of(wrong::stale_velocities.stages);
  CHECK_THAT(order_in_position(bug, drone, 1.0 / 8, 8), WithinAbs(2, 0.1));
  CHECK_THAT(order_in_position(bug, parachute, 1.0 / 32, 2), WithinAbs(4, 0.1));
  CHECK_THAT(order_in_position(bug, engine_on, 0.25, 4), WithinAbs(4, 0.1));
}

TEST_CASE("Of the three scenes only the rocket finds a clock that stands still") {
  const auto bug = wrong::method_of(wrong::stopped_clock.stages);
  CHECK_THAT(order_in_position(bug, drone, 0.25, 8), WithinAbs(4, 0.1));
  CHECK_THAT(order_in_position(bug, parachute, 1.0 / 32, 2), WithinAbs(4, 0.1));
  CHECK_THAT(order_in_position(bug, engine_on, 0.25, 4), WithinAbs(1, 0.1));
}

TEST_CASE("One step of RK4 against its formula tells every bug of the table") {
  const auto all_of_it = [](double x, double v, double t) { return t * t - x * x * x - v / 2; };
  const auto end = [&](const wrong::Stages& stages) {
    return measure::after(wrong::method_of(stages), all_of_it, State<double>{1, 2}, 0.5, 1);
  };
  double x = 1, v = 2;
  integrate::rk4(x, v, 0.0, 0.5, all_of_it);
  CHECK_THAT(end({}).x, WithinRel(x, 1e-14));
  CHECK_THAT(end({}).v, WithinRel(v, 1e-14));
  for (const auto& bug : {wrong::fourth_looks_too_soon, wrong::third_is_second,
                          wrong::stale_velocities, wrong::equal_weights, wrong::stopped_clock}) {
    CHECK(std::abs(end(bug.stages).v - v) > 1e-3);
  }
}

TEST_CASE("Dormand-Prince has order five for six evaluations") {
  check_order(measure::dopri5, drone, 1.0, 8, 5);
  CHECK(measure::evaluations_per_step(measure::dopri5, drone, frame) == 6);
}

TEST_CASE("The comet takes RK4 more than a hundred times the evaluations of an adaptive step") {
  const Passage smooth = pass(1);
  const long rate = 25 * smooth.total() / long(comet_year);  // a hundred times as many evaluations
  CHECK(error_of_equal_steps(rate) > smooth.error);
  CHECK(error_of_equal_steps(2 * rate) < smooth.error);
}

TEST_CASE("Sixty equal steps a second throw the comet out") {
  const auto end = measure::after(rk4, comet, comet.exact(-comet_year / 2), frame, 1200);
  CHECK(comet.energy(end.x, end.v) > 0);
  CHECK(comet.energy(comet.start().x, comet.start().v) < 0);
}

TEST_CASE("In its dearest frame the comet costs twelve times what it costs in most") {
  const Passage framed = pass(1200);
  CHECK(framed.dearest() > 12 * framed.cheapest());
  CHECK(framed.dearest() < 13 * framed.cheapest());
}

TEST_CASE("Cut up by frames the adaptive step asks more than seven times as often") {
  CHECK(pass(1200).total() > 7 * pass(1).total());
  CHECK(pass(1200).total() < 8 * pass(1).total());
}

TEST_CASE("With an adaptive step, players at 60 and at 144 frames a second get two comets") {
  const Passage sixty = pass(1200), fast = pass(2880), again = pass(1200);
  CHECK(sixty.end.x == again.end.x);
  // By the tolerance, and not by a number of steps that each frame takes alike.
  CHECK(sixty.dearest() > 2 * sixty.cheapest());
  CHECK(fast.dearest() > 2 * fast.cheapest());
  const double apart = (sixty.end.x - fast.end.x).norm();
  CHECK(apart > micrometre);
  CHECK(apart < 10 * micrometre);
  // Far more than rounding, which moves the start by the last bit.
  auto nudged = comet.exact(-comet_year / 2);
  nudged.x[0] = std::nextafter(nudged.x[0], 0);
  CHECK(apart > 100 * (sixty.end.x - pass(1200, nudged).end.x).norm());
}

TEST_CASE("Read out of its path in frames, the comet is the same for all and costs nothing more") {
  const Passage alone = pass(1), sixty = read(1200), fast = read(2880);
  CHECK((sixty.end.x == fast.end.x && sixty.end.v == fast.end.v));
  CHECK(sixty.total() == fast.total());
  CHECK(sixty.total() == alone.total());
  // A step is taken in few of the frames, and most are read out of one that is there.
  CHECK(sixty.cheapest() == 0);
}

TEST_CASE("Running ahead of its frames spares the comet one evaluation in its dearest frame") {
  CHECK(read(1200).dearest() == pass(1200).dearest() - 1);
  CHECK(read(1200).total() < pass(1200).total() / 7);
}

TEST_CASE("In no frame is the comet that runs ahead further off than at the end of its year") {
  const Passage read_out = read(1200);
  CHECK(read_out.farthest == read_out.error);
  CHECK(read_out.farthest < 1.01 * pass(1).error);
}

TEST_CASE("In steps of one length, players with other frames get the same comet to the last bit") {
  const Passage sixty = step_equally(1200), fast = step_equally(2880);
  CHECK(sixty.end.x == fast.end.x);
  CHECK(sixty.end.v == fast.end.v);
  CHECK(sixty.error < 0.01);
}

TEST_CASE("Equal steps cost the comet about the same in every frame") {
  // Twelve hundred frames may leave the last of the steps to one more.
  const Passage sixty = step_equally(1200);
  for (std::size_t n = 0; n < 1200; ++n) {
    CHECK((sixty.evaluations[n] == 64 || sixty.evaluations[n] == 68));
  }
}

TEST_CASE("Midpoint and Heun do the same to a spring") {
  for (const double homega : {0.1, 1.0, 2.0}) {
    const Spring<> spring{.omega = 1, .zeta = 0.2};
    const auto one = measure::step_matrix(midpoint, spring, homega);
    const auto other = measure::step_matrix(measure::heun, spring, homega);
    CHECK((one - other).norm() < 1e-14);
  }
}

TEST_CASE("At five swings a second, one per cent a minute takes RK4 152 steps a second") {
  const auto left = [](long rate) {
    return left_after(60 * rate, swinging(5).omega / double(rate));
  };
  CHECK(left(152) > 0.99);
  CHECK(left(150) < 0.99);
}

TEST_CASE("Folded into one matrix, a step of RK4 takes less than a seventh of the time") {
  const measure::Times& times = measure::recorded_times();
  CHECK_THAT(times.at("spring/RK4").median / times.at("spring/RK4 folded").median,
             WithinAbs(7.5, 0.5));
  CHECK_THAT(times.at("spring/exact folded").median / times.at("spring/RK4 folded").median,
             WithinAbs(1, 0.05));
}

TEST_CASE(
    "A spring left alone is a denormal number after six minutes, and still after three hours") {
  CHECK_THAT(comes_to_rest() / 60, WithinAbs(6, 0.2));
  auto s = at_rest.start();
  s = measure::after(rk4, at_rest, s, frame, 3 * 3600 * 60);
  CHECK(std::fpclassify(s.x) == FP_SUBNORMAL);
  CHECK(std::fpclassify(s.v) == FP_SUBNORMAL);
}

TEST_CASE("At rest the same steps take longer") {
  const measure::Times& times = measure::recorded_times();
  for (const std::string step : {"spring/RK4", "spring/RK4 folded"})
    CHECK(times.at(step + " at rest").lower > 1.1 * times.at(step).upper);
}

TEST_CASE("In a braking step of c h = 1 the four slopes are 1, 1/2, 3/4 and 1/4, their mean 5/8") {
  const auto slopes = braking_slopes(1);
  CHECK(slopes == std::vector<double>{1, 0.5, 0.75, 0.25});
  double x = 0, v = 1;
  integrate::rk4(x, v, 0.0, 1.0, [](double, double velocity, double) { return -velocity; });
  CHECK_THAT(v, WithinRel(1 - 5.0 / 8, 1e-14));
}

TEST_CASE("On a spring a step of RK4 adds four terms, each a quarter turn on from the one before") {
  for (const double z : {0.3, 1.5, 2.5}) {
    const Spring<> spring{.omega = 7, .x0 = 1};
    const auto end = measure::after(rk4, spring, spring.start(), z / 7, 1);
    CHECK_THAT(end.x, WithinRel(1 - z * z / 2 + z * z * z * z / 24, 1e-12));
    CHECK_THAT(end.v / 7, WithinRel(-z + z * z * z / 6, 1e-12));
  }
  const auto end = measure::after(rk4, Spring<>{}, State<double>{1, 0}, 1.5, 1);
  CHECK_THAT(std::hypot(end.x, end.v), WithinAbs(0.941, 5e-4));
  CHECK(std::atan2(-end.v, end.x) < 1.5);
}

TEST_CASE("The estimate of Dormand-Prince falls with the fifth power of the step") {
  const auto estimate = [](double step) {
    auto s = shuttle.start();
    auto a = integrate::dopri5_start(s.x, s.v, 0.0, shuttle);
    return integrate::dopri5(s.x, s.v, a, 0.0, step, shuttle).v.norm();
  };
  for (const double step : {0.04, 0.02, 0.01}) {
    CHECK_THAT(std::log2(estimate(step) / estimate(step / 2)), WithinAbs(5, 0.2));
  }
}

TEST_CASE("An estimate 32 times the tolerance makes the next try 0.45 times as long") {
  const integrate::Dopri5Verdict<double> wrong(32, 1), right(1.0 / 32, 0), lucky(0, 0);
  CHECK(!wrong.good);
  CHECK_THAT(wrong.change, WithinRel(0.45, 1e-12));
  CHECK(right.good);
  CHECK_THAT(right.change, WithinRel(1.8, 1e-12));
  CHECK(lucky.change == 5);
  CHECK((!integrate::Dopri5Verdict<double>(1e9, 0).good));
  CHECK((integrate::Dopri5Verdict<double>(1e9, 0).change == 0.2));
}
