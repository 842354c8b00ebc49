// SPDX-License-Identifier: MIT-0
// The claims of chapter 4. Each name is a sentence that the chapter says.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include "../cast.h"
#include "blows.h"
#include "measure/energy.h"
#include "measure/error.h"
#include "measure/evaluations.h"
#include "measure/methods.h"
#include "measure/order.h"
#include "measure/stability.h"
#include "parachute.h"
#include "scenes/linear_drag.h"
#include "scenes/pendulum.h"
#include "shelf/link.h"
#include "shelf/soft_constraint.h"
#include "slide.h"
#include "soft.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using measure::backward_euler;
using measure::euler;
using measure::spectral_radius;
using measure::symplectic_euler;
using measure::trapezoid;
using scenes::LinearDrag;
using scenes::Spring;
using scenes::State;

namespace {

const double rounding = std::numeric_limits<double>::epsilon();

/// A brake without gravity and with one as its drag.
constexpr LinearDrag<> unit_brake{.c = 1, .g = 0, .v0 = 1};

/// The speed after one step of a brake.
template <class Step>
double braked(Step step, double ch) {
  return measure::after(step, unit_brake, unit_brake.start(), ch, 1).v;
}

/// predicted_euler() with so many corrections.
auto corrected(int corrections) {
  return [corrections](auto& x, auto& v, auto t, auto h, auto&& a) {
    integrate::predicted_euler(x, v, t, h, a, corrections);
  };
}

template <class Step>
double drag_limit(Step step) {
  return measure::stability_limit(step, unit_brake, 1e-3, 10);
}

}  // namespace

TEST_CASE("Euler, symplectic Euler and RK4 all lose the bar at 60 steps a second") {
  const auto away = [](auto step) {
    return std::abs(measure::after(step, bar, bar.start(), frame, 10).x);
  };
  CHECK(away(euler) > 1e6);
  CHECK(away(symplectic_euler) > 1e16);
  CHECK(away(measure::rk4) > 2.4e22);  // as far as Andromeda
  CHECK(away(backward_euler) < bar.x0);
}

TEST_CASE("To hold the bar Euler needs 3000 steps a second, symplectic Euler 332, RK4 204") {
  const auto rate = [](auto step) { return 1 / measure::stability_limit(step, bar, 1e-5, 1); };
  CHECK_THAT(rate(euler), WithinRel(3000, 1e-6));
  CHECK_THAT(rate(symplectic_euler), WithinAbs(331.5, 0.5));
  CHECK_THAT(rate(measure::rk4), WithinAbs(203.5, 0.5));
}

TEST_CASE("Four frames of backward Euler bring the bar to rest within a tenth of a micrometre") {
  CHECK(std::abs(measure::after(measure::backward_euler_spring, bar, bar.start(), frame, 4).x) <
        1e-7);
  CHECK(std::abs(measure::after(measure::backward_euler_spring, bar, bar.start(), frame, 3).x) >
        1e-7);
  CHECK(std::abs(bar.exact(4 * frame).x) > 1e-6);  // the true one still swings
}

TEST_CASE("Each step of backward Euler on a circle starts outside the circle that it ends on") {
  auto s = drone.start();
  for (int n = 0; n < 1000; ++n) {
    const auto before = s;
    integrate::backward_euler_spring(s.x, s.v, frame, drone.omega, 0.0);
    CHECK(s.x.norm() < before.x.norm());
    CHECK_THAT(s.x.dot(s.v), WithinAbs(0, 1e-10));  // still at right angles, so a tangent
    CHECK(((s.x - before.x) - frame * s.v).norm() < 10 * rounding * s.x.norm());
  }
}

TEST_CASE("Backward Euler divides the energy of a circle by what Euler multiplies it with") {
  const auto energy = [](const auto& x, const auto& v) { return drone.energy(x, v); };
  for (const double step : {frame, 0.1, 1.0, 10.0}) {
    const double up = 1 + measure::drift(euler, drone, step, 1, energy).last;
    const double down = 1 + measure::drift(backward_euler, drone, step, 1, energy).last;
    CHECK_THAT(up * down, WithinRel(1, 1e-13));
    CHECK_THAT(down, WithinRel(left_in_a_step(step * drone.omega), 1e-13));
  }
}

TEST_CASE("Ten turns of backward Euler draw the drone a third of the way to its tower") {
  const auto end = measure::after(backward_euler, drone, drone.start(), frame, 10 * turn);
  CHECK_THAT(end.x.norm(), WithinAbs(6.63, 0.01));
  const auto late = measure::after(backward_euler, drone, drone.start(), frame, 200 * turn);
  CHECK(late.x.norm() < 0.01);
}

TEST_CASE("Backward Euler brakes at every step without turning round") {
  for (const double ch : {0.1, 1.0, 2.0, 10.0, 1e3, 1e6}) {
    CHECK_THAT(braked(backward_euler, ch), WithinAbs(1 / (1 + ch), 2 * rounding));
    CHECK(braked(backward_euler, ch) > 0);
    CHECK(std::abs(braked(euler, ch) - (1 - ch)) <= rounding * ch);
  }
}

TEST_CASE("Backward Euler holds every spring at every step") {
  for (const double zeta : {0.0, 0.1, 0.5, 1.0, 5.0, 50.0}) {
    for (const double homega : {0.01, 0.1, 1.0, 10.0, 1e3}) {
      CHECK(spectral_radius(backward_euler, Spring<>{.zeta = zeta}, homega) < 1);
    }
  }
}

TEST_CASE(
    "Backward Euler divides each part of a spring's motion by one plus the step times its rate") {
  for (const double zeta : {0.0, 0.1, 0.9, 1.5, 5.0}) {
    for (const double homega : {0.01, 1.0, 10.0, 1e3}) {
      const auto matrix = measure::step_matrix(backward_euler, Spring<>{.zeta = zeta}, homega);
      const std::complex<double> root = std::sqrt(std::complex<double>(zeta * zeta - 1));
      std::complex<double> product = 1, sum = 0;
      for (const double sign : {-1.0, 1.0}) {
        const std::complex<double> factor = 1.0 / (1.0 + homega * (zeta + sign * root));
        product *= factor;
        sum += factor;
        if (zeta < 1) {
          CHECK_THAT(std::norm(factor),
                     WithinRel(1 / (1 + 2 * zeta * homega + homega * homega), 1e-12));
        }
      }
      CHECK_THAT(matrix.determinant(), WithinAbs(product.real(), 1e-12));
      CHECK_THAT(matrix.trace(), WithinAbs(sum.real(), 1e-12));
    }
  }
}

TEST_CASE("When a parachute opens the derived step ends nearer to the truth than one solve") {
  // The truth: (u - 5) / (u + 5) falls like exp(-2 g t / 5).
  const double part = (50.0 - 5) / (50 + 5) * std::exp(-2 * 9.81 * slow / 5);
  const double truth = 5 * (1 + part) / (1 - part);
  const double derived = -derived_parachute(diving, slow);
  const double once = -parachute_solved_once(diving, slow);
  CHECK_THAT(truth, WithinAbs(17.4, 0.05));
  CHECK_THAT(derived, WithinAbs(25.5, 0.05));
  CHECK_THAT(once, WithinAbs(30.3, 0.05));
  // It is the end itself: its slope leads back to the start.
  CHECK_THAT(derived - slow * (9.81 - parachute.k * derived * derived), WithinRel(50, 1e-13));
}

TEST_CASE("On a spring the derived step, the solved one and Newton's are one step") {
  const State<double> start{0.3, -2};
  for (const double zeta : {0.0, 0.1, 1.0, 5.0}) {
    const Spring<> spring{.omega = 600, .zeta = zeta};
    const auto derived = measure::after(measure::backward_euler_spring, spring, start, frame, 1);
    const auto solved = measure::after(backward_euler, spring, start, frame, 1);
    const auto newton = measure::after(measure::backward_euler_newton, spring, start, frame, 1);
    // x is h omega = 10 times the rounding of v, and v is of the size of omega x.
    const double size = std::abs(start.x) + std::abs(start.v) / spring.omega;
    for (const auto& other : {solved, newton}) {
      CHECK_THAT(other.x, WithinAbs(derived.x, 50 * rounding * size));
      CHECK_THAT(other.v, WithinAbs(derived.v, 50 * rounding * size * spring.omega));
    }
  }
}

TEST_CASE("One correction has half of Euler's limit on drag") {
  CHECK_THAT(drag_limit(euler), WithinRel(2, 1e-9));
  CHECK_THAT(drag_limit(corrected(1)), WithinRel(1, 1e-9));
}

TEST_CASE("The second correction moves the limit on drag to 1.353, the third takes it back to 1") {
  CHECK_THAT(drag_limit(corrected(2)), WithinAbs(1.353, 0.0005));
  CHECK_THAT(drag_limit(corrected(3)), WithinRel(1, 1e-9));
}

TEST_CASE("Corrections add up a series that converges below c h = 1 and nowhere else") {
  const double right = 1 / (1 + 0.9), wrong = 1 / (1 + 1.1);
  CHECK_THAT(braked(corrected(300), 0.9), WithinAbs(right, 1e-12));
  CHECK(std::abs(braked(corrected(300), 1.1) - wrong) > 1e6);
  for (int n = 1; n <= 20; ++n) {
    double sum = 0;
    for (int power = 0; power <= n + 1; ++power) sum += std::pow(-0.9, power);
    CHECK_THAT(braked(corrected(n), 0.9), WithinAbs(sum, 1e-13));
    CHECK(drag_limit(corrected(n)) > 0.99);
    CHECK(drag_limit(corrected(n)) < 1.36);
  }
}

TEST_CASE("One correction draws the drone in as far as backward Euler does, to a centimetre") {
  const auto end = [](auto step) {
    return measure::after(step, drone, drone.start(), frame, 10 * turn).x.norm();
  };
  CHECK_THAT(end(corrected(1)), WithinAbs(end(backward_euler), 0.01));
}

TEST_CASE("The talk's predictor-corrector takes the steps of Heun's method") {
  for (const double step : {frame, 0.5}) {
    const auto mine = measure::after(slide, drone, drone.start(), step, 20);
    const auto heun = measure::after(measure::heun, drone, drone.start(), step, 20);
    CHECK((mine.x - heun.x).norm() < 1e-12 * heun.x.norm());
    CHECK((mine.v - heun.v).norm() < 1e-12 * heun.v.norm());
  }
  State<double> mine{0, diving}, heun = mine;
  mine = measure::after(slide, parachute, mine, 0.01, 20);
  heun = measure::after(measure::heun, parachute, heun, 0.01, 20);
  CHECK_THAT(mine.v, WithinRel(heun.v, 1e-12));
  CHECK_THAT(mine.x, WithinRel(heun.x, 1e-12));
}

TEST_CASE("The talk's predictor-corrector has order two") {
  const auto rows = measure::halvings(slide, drone, 1.0 / 15, 8.0, 4);
  CHECK_THAT(rows.back().position_order, WithinAbs(2, 0.1));
  CHECK_THAT(rows.back().velocity_order, WithinAbs(2, 0.1));
}

TEST_CASE("The talk's predictor-corrector has Euler's limit on drag and gains on every spring") {
  CHECK_THAT(drag_limit(slide), WithinRel(2, 1e-9));
  for (const double homega : {0.1, 0.5, 2.0}) {
    CHECK(spectral_radius(slide, Spring<>{}, homega) > 1 + 1e-6);
  }
}

TEST_CASE("In a second backward Euler takes half of a slow spring and all of a fast one") {
  const auto left = [](const Spring<>& spring) {
    const auto energy = [&](double x, double v) { return spring.energy(x, v); };
    return 1 + measure::drift(backward_euler, spring, frame, 60, energy).last;
  };
  CHECK_THAT(left(swinging(1)), WithinAbs(0.52, 0.005));
  CHECK_THAT(left(swinging(2)), WithinAbs(0.076, 0.001));
  CHECK(left(Spring<>{.omega = suspension.omega}) < 0.002);
}

TEST_CASE("In a second BDF2 leaves 99 per cent of a spring of one swing, and 93 of one of two") {
  CHECK_THAT(left_by_bdf2(swinging(1)), WithinAbs(0.991, 0.0005));
  CHECK_THAT(left_by_bdf2(swinging(2)), WithinAbs(0.93, 0.005));
  CHECK_THAT(left_by_bdf2(undamped_suspension), WithinAbs(0.72, 0.005));
}

TEST_CASE(
    "Begun by backward Euler, its own start or the trapezoid rule, BDF2 leaves 98.1, 99.1 or 99.7 "
    "per cent") {
  const auto spring = swinging(1);
  CHECK_THAT(left_by_bdf2(spring, measure::backward_euler), WithinAbs(0.981, 0.0005));
  CHECK_THAT(left_by_bdf2(spring), WithinAbs(0.991, 0.0005));
  CHECK_THAT(left_by_bdf2(spring, measure::trapezoid), WithinAbs(0.997, 0.0005));
}

TEST_CASE("BDF2 has order two on the drone, in position and in velocity") {
  const auto rows = measure::halvings(measure::bdf2, drone, 1.0 / 60, 8.0, 4);
  CHECK_THAT(rows.back().position_order, WithinAbs(2, 0.1));
  CHECK_THAT(rows.back().velocity_order, WithinAbs(2, 0.1));
}

TEST_CASE("BDF2 holds every spring in even steps and brings the bar to rest") {
  for (const double zeta : {0.0, 0.1, 1.0, 5.0, 50.0}) {
    for (const double homega : {0.01, 0.1, 1.0, 10.0, 1e3}) {
      CHECK(spectral_radius(measure::bdf2, Spring<>{.zeta = zeta}, homega) < 1);
    }
  }
  CHECK(std::abs(measure::after(measure::bdf2, bar, bar.start(), frame, 10).x) < 1e-7);
}

TEST_CASE("Backward Euler has order one on the drone, in position and in velocity") {
  const auto rows = measure::halvings(backward_euler, drone, 1.0 / 120, 8.0, 4);
  CHECK_THAT(rows.back().position_order, WithinAbs(1, 0.1));
  CHECK_THAT(rows.back().velocity_order, WithinAbs(1, 0.1));
}

TEST_CASE("On drag backward Euler errs as far as Euler, to the other side") {
  const auto error = [](auto step) {
    const auto end = measure::after(step, unit_brake, unit_brake.start(), 0.01, 100);
    return end.v - unit_brake.exact(1).v;
  };
  CHECK(error(euler) < 0);
  CHECK_THAT(error(backward_euler) / error(euler), WithinAbs(-1, 0.02));
}

TEST_CASE("Backward Euler's terminal speed in linear drag is right to rounding") {
  for (const double step : {frame, 0.1, 1.0, 10.0}) {
    CHECK_THAT(-measure::after(backward_euler, leaf, leaf.start(), step, 3000).v,
               WithinRel(leaf.terminal_speed(), 1e-12));
  }
}

TEST_CASE("Under a constant force backward Euler takes the steps of symplectic Euler") {
  const LinearDrag<> ball{.c = 0, .v0 = 5};
  for (const double step : {frame, 0.1, 1.0}) {
    const auto end = measure::after(backward_euler, ball, ball.start(), step, 100);
    const auto same = measure::after(symplectic_euler, ball, ball.start(), step, 100);
    CHECK(end.x == same.x);
    CHECK(end.v == same.v);
    const double t = 100 * step;
    CHECK_THAT(end.x - ball.exact(t).x, WithinRel(-ball.g * step * t / 2, 1e-9));
  }
}

TEST_CASE("A step of backward Euler asks for the acceleration once and solves once") {
  int solves = 0;
  const measure::Counted counted{suspension};
  const auto solve = [&](double, double, double, double p, double q, double& change) {
    ++solves;
    change = change / (1 - p * suspension.omega * suspension.omega - q * suspension.damping());
    return true;
  };
  double x = 1, v = 0;
  REQUIRE(integrate::backward_euler(x, v, 0.0, frame, counted, solve));
  CHECK(counted.evaluations == 1);
  CHECK(solves == 1);
}

TEST_CASE("At ten steps a second a parachute opens without throwing its diver, solved once") {
  double x = 0, v = diving;
  REQUIRE(integrate::backward_euler(x, v, 0.0, slow, parachute, solve_parachute));
  CHECK(v < 0);
  CHECK(v > diving);
  CHECK_THAT(v, WithinAbs(-30.3, 0.05));
}

TEST_CASE("On a parachute each of Newton's iterations squares the error, and six are enough") {
  const auto found = changes_of_parachute();
  CHECK(found.size() == 6);
  for (std::size_t n = 2; n < 5; ++n) {
    // The error after an iteration is about k h over the slope times that before, squared.
    const double factor = found[n] / (found[n - 1] * found[n - 1]);
    CHECK(factor > 0.005);
    CHECK(factor < 0.02);
  }
}

TEST_CASE("The trapezoid rule has order two") {
  const auto rows = measure::halvings(trapezoid, drone, 1.0 / 15, 8.0, 4);
  CHECK_THAT(rows.back().position_order, WithinAbs(2, 0.1));
  CHECK_THAT(rows.back().velocity_order, WithinAbs(2, 0.1));
}

TEST_CASE("The trapezoid rule keeps the energy of an undamped spring at every step size") {
  for (const double homega : {0.1, 1.0, 10.0}) {
    const Spring<> spring{.omega = 1};
    const auto energy = [&](double x, double v) { return spring.energy(x, v); };
    CHECK(measure::drift(trapezoid, spring, homega, 1000, energy).largest < 1e-11);
  }
}

TEST_CASE("The trapezoid rule holds every damped spring at every step") {
  for (const double zeta : {0.1, 1.0, 5.0}) {
    for (const double homega : {0.01, 0.1, 1.0, 10.0, 1e3}) {
      CHECK(spectral_radius(trapezoid, Spring<>{.zeta = zeta}, homega) < 1);
    }
  }
}

TEST_CASE("On the bar the trapezoid rule leaves 96 per cent of the swing in each step") {
  CHECK_THAT(spectral_radius(trapezoid, bar, frame), WithinAbs(0.962, 0.0005));
  CHECK_THAT(spectral_radius(backward_euler, bar, frame), WithinAbs(0.0985, 0.0005));
  int turned = 0;
  auto s = bar.start();
  double before = s.v;
  measure::run(trapezoid, bar, s, frame, 60, [&](double t, const auto& now) {
    if (t > 0) turned += now.v * before < 0;
    before = now.v;
  });
  CHECK(turned > 50);
}

TEST_CASE("Implicit in the velocities alone, a step loses the bar") {
  const auto velocities_alone = [](double& x, double& v, double t, double h, auto&& a) {
    const double slope = -2 * bar.zeta * bar.omega;  // of the acceleration by the velocity
    v = v + h * a(x, v, t) / (1 - h * slope);
    x = x + h * v;
  };
  CHECK(std::abs(measure::after(velocities_alone, bar, bar.start(), frame, 10).x) > 1e12);
}

TEST_CASE("The soft constraint of Box2D is backward Euler on a spring") {
  for (const double zeta : {0.0, 0.2, 1.0, 10.0}) {
    for (const double omega : {1.0, 30.0, 600.0}) {
      double x = 0.3, v = -2;
      integrate::backward_euler_spring(x, v, frame, omega, zeta);
      double stretch = 0.3, rate = -2;
      soft_constraint(stretch, rate, frame, omega, zeta);
      // Terms of the size of v and of omega x cancel.
      const double size = 2 + omega * 0.3;
      CHECK_THAT(rate, WithinAbs(v, 10 * rounding * size));
      CHECK_THAT(stretch, WithinAbs(x, 10 * rounding * (0.3 + frame * size)));
    }
  }
}

TEST_CASE("XPBD's link, Box2D's soft constraint and backward_euler_spring take one step") {
  const auto norm = [](double d) { return std::abs(d); };
  const auto dot = [](double a, double b) { return a * b; };
  for (const double omega : {1.0, 30.0, 600.0}) {
    const double w = 0.5, length = 1, x = 0.3, v = -2;
    double spring = x, speed = v;
    integrate::backward_euler_spring(spring, speed, frame, omega, 0.0);

    double post = 0, link = length + x + frame * v, tension = 0;
    shelf::link(post, link, tension, 0.0, w, length, w / (omega * omega), frame, norm);
    CHECK_THAT(link - length, WithinAbs(spring, 10 * rounding));

    double wall = 0, rate = v, impulse = 0;
    const auto soft = shelf::softness(frame, omega, 0.0);
    shelf::soft_constraint(wall, rate, impulse, 1.0, x, 0.0, w, soft, dot);
    const double size = 2 + omega * 0.3;
    CHECK_THAT(rate, WithinAbs(speed, 10 * rounding * size));
    CHECK_THAT(x + frame * rate, WithinAbs(spring, 10 * rounding * (0.3 + frame * size)));
  }
}

TEST_CASE("A soft constraint adds half of h omega to a small damping ratio") {
  for (const double homega : {0.01, 0.05, 0.1}) {
    const auto got = effective_spring(soft_step, {.omega = homega / frame}, frame);
    CHECK_THAT(got.zeta, WithinRel(homega / 2, 0.01));
  }
}

TEST_CASE("Asked for 5 Hz without damping a soft constraint gives 0.24 at 60 steps a second") {
  CHECK_THAT(effective_spring(soft_step, swinging(5), frame).zeta, WithinAbs(0.243, 0.001));
  CHECK_THAT(effective_spring(soft_step, swinging(5), 2 * frame).zeta, WithinAbs(0.42, 0.005));
  CHECK_THAT(effective_spring(soft_step, swinging(5), frame / 4).zeta, WithinAbs(0.065, 0.001));
}

TEST_CASE(
    "Solved twice in a substep, as Box2D does, a soft constraint takes nearly twice as much") {
  // Box2D itself, at the commit that the engines' page names, gave 0.130, 0.25 and 0.46.
  CHECK_THAT(effective_spring(soft_step_twice, swinging(5), frame / 4).zeta,
             WithinAbs(0.130, 0.001));
  CHECK_THAT(effective_spring(soft_step_twice, swinging(5), frame / 2).zeta,
             WithinAbs(0.25, 0.005));
  CHECK_THAT(effective_spring(soft_step_twice, swinging(5), frame).zeta, WithinAbs(0.46, 0.005));
  for (const double h : {frame / 4, frame / 2, frame}) {
    const double left = measure::step_matrix(soft_step_twice, swinging(5), h).determinant();
    CHECK_THAT(left, WithinRel(std::pow(1 + std::pow(h * swinging(5).omega, 2), -2), 1e-12));
  }
}

TEST_CASE("One correction holds an undamped spring while h omega is at most one") {
  CHECK_THAT(measure::stability_limit(corrected(1), scenes::Spring<>{}, 0.01, 3),
             WithinRel(1, 1e-6));
  for (const double homega : {0.1, 0.5, 0.999}) {
    CHECK(measure::spectral_radius(corrected(1), scenes::Spring<>{}, homega) <= 1);
    CHECK(measure::spectral_radius(measure::euler, scenes::Spring<>{}, homega) > 1);
  }
}

TEST_CASE("Asked for 5 Hz a soft constraint swings 4.6 times a second at 60 steps and 3.9 at 30") {
  for (const auto& [rate, swings] : {std::pair{60, 4.6}, {30, 3.9}}) {
    // A step turns the state by the angle whose tangent is h omega.
    const double turned = std::atan(swinging(5).omega / rate) / (2 * std::numbers::pi) * rate;
    CHECK_THAT(turned, WithinAbs(swings, 0.05));
    const auto got = effective_spring(soft_step, swinging(5), 1.0 / rate);
    CHECK_THAT(got.omega * std::sqrt(1 - got.zeta * got.zeta) / (2 * std::numbers::pi),
               WithinRel(turned, 1e-9));
  }
}

TEST_CASE(
    "With its third number a soft constraint ends at one velocity, from any guess, after any "
    "number of passes") {
  const double omega = 30, zeta = 0.2, stretch = 0.3, start = -2;
  const double damping_and_step = 2 * zeta + frame * omega;
  const double stiff = frame * omega * damping_and_step, bias = omega / damping_and_step * stretch;
  const double mass_scale = stiff / (1 + stiff);
  const auto end = [&](double guess, int passes, double impulse_scale) {
    double v = start + guess, given = guess;  // impulses for a mass of one
    for (; passes > 0; --passes) {
      const double impulse = -mass_scale * (v + bias) - impulse_scale * given;
      given += impulse;
      v += impulse;
    }
    return v;
  };
  double x = stretch, v = start;
  soft_constraint(x, v, frame, omega, zeta);
  for (const double guess : {0.0, -1.0, 5.0}) {
    for (const int passes : {1, 2, 10}) {
      CHECK_THAT(end(guess, passes, 1 - mass_scale), WithinRel(v, 1e-13));
    }
  }
  CHECK(std::abs(end(5, 1, 0) - v) > 1);     // without it the guess stays in
  CHECK(std::abs(end(0, 10, 0) - v) > 0.1);  // and every pass stiffens
}

TEST_CASE("To keep nine tenths of a spring of two swings for a second takes 1500 steps") {
  const auto left = [](double rate) {
    return std::pow(left_in_a_step(swinging(2).omega / rate), rate);
  };
  CHECK_THAT(left(1500), WithinAbs(0.9, 0.001));
}

namespace {

/// One step of Baraff and Witkin's: the tangent at x, from where the force has yet to move on.
template <class Scene>
State<double> with_the_tangent_at_x(const Scene& scene, State<double> s, double h) {
  double change = 0;
  scene.jacobian(s.x, s.v, 0.0, [&](int, int, double dadx, double dadv) {
    change = h * (scene(s.x, s.v, 0.0) + h * dadx * s.v) / (1 - h * dadv - h * h * dadx);
  });
  return {s.x + h * (s.v + change), s.v + change};
}

/// One solve, and one iteration of Newton's.
template <class Scene>
std::array<State<double>, 2> once_and_first(const Scene& scene, State<double> s, double h) {
  const auto solve = [&](double x, double v, double t, double p, double q, double& change) {
    scene.jacobian(x, v, t, [&](int, int, double dadx, double dadv) {
      change = change / (1 + p * dadx + q * dadv);
    });
    return true;
  };
  const auto nothing = [](double) { return 0.0; };
  State<double> once = s, first = s;
  CHECK(integrate::backward_euler(once.x, once.v, 0.0, h, scene, solve));
  const int iterations =
      integrate::backward_euler_newton(first.x, first.v, 0.0, h, scene, solve, nothing, 1.0);
  CHECK(iterations == 1);
  return {once, first};
}

}  // namespace

TEST_CASE(
    "One solve is the first of Newton's iterations, and Baraff and Witkin's on linear forces "
    "alone") {
  const State<double> start{1, -0.7};
  for (const double h : {0.01, 0.1, 0.5}) {
    CAPTURE(h);
    const Spring<> spring{.omega = 3, .zeta = 0.2};
    const auto linear = once_and_first(spring, start, h);
    CHECK_THAT(linear[0].v, WithinRel(with_the_tangent_at_x(spring, start, h).v, 100 * rounding));
    const scenes::Pendulum<> pendulum;
    const auto [once, first] = once_and_first(pendulum, start, h);
    CHECK(once.x == first.x);
    CHECK(once.v == first.v);
    // They part by the bend of the force over the way h v, which is of third order in h.
    const double apart = std::abs(once.v - with_the_tangent_at_x(pendulum, start, h).v);
    CHECK(apart > 0.1 * h * h * h);
  }
}

TEST_CASE(
    "A stiff rope on its nail is gone after three frames, predicted or not, and the solved one "
    "stays") {
  const scenes::Rope<> rope{.count = 20, .k = 1e4};
  const auto largest = [&](auto step, int frames) {
    return measure::after(step, rope, rope.start(), frame, frames).x.cwiseAbs().maxCoeff();
  };
  CHECK(largest(measure::symplectic_euler, 3) > 3);
  CHECK(largest(measure::PredictedEuler{}, 3) > 3);
  for (int frames = 1; frames <= 120; ++frames)
    REQUIRE(largest(measure::backward_euler, frames) < 2.1);
}
