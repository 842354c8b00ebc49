// SPDX-License-Identifier: MIT-0
// Halving the step halves the error: not less, and not more.
#include <Eigen/Core>
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "../scenes/runge_kutta.h"
#include "measure/run.h"
#include "scenes/orbit.h"
#include "scenes/pendulum.h"
#include "scenes/quadratic_drag.h"
#include "scenes/sine.h"
#include "scenes/state.h"

using scenes::State;

namespace {

double size(double x) {
  return std::abs(x);
}
double size(const Eigen::Vector2d& x) {
  return x.norm();
}

struct Errors {
  double position = 0, velocity = 0;
};

// The largest errors at eight times of a run, against a reference that is far more exact. One
// instant would not do: there an error can pass through zero.
template <class Step, class Scene, class Vec>
Errors largest_errors(Step step, const Scene& scene, const State<Vec>& start, double part,
                      int steps) {
  const double h = part / steps;
  State<Vec> s = start;
  State<Vec> truth = start;
  Errors largest;
  for (int n = 0; n < 8 * steps; ++n) {
    step(s.x, s.v, n * h, h, scene);
    if ((n + 1) % steps != 0) continue;
    const auto later = [&](const Vec& x, const Vec& v, double t) {
      return scene(x, v, t + (n + 1) * h - part);
    };
    truth = runge_kutta(later, truth, part, 400);
    largest.position = std::max(largest.position, size(Vec(s.x - truth.x)));
    largest.velocity = std::max(largest.velocity, size(Vec(s.v - truth.v)));
  }
  return largest;
}

template <class Step, class Scene, class Vec>
void check_order(int order, Step step, const Scene& scene, const State<Vec>& start, double part,
                 int steps) {
  Errors coarse = largest_errors(step, scene, start, part, steps);
  double before = 0;
  for (int halving = 0; halving < 3; ++halving) {
    steps *= 2;
    const Errors fine = largest_errors(step, scene, start, part, steps);
    const double position = std::log2(coarse.position / fine.position);
    const double velocity = std::log2(coarse.velocity / fine.velocity);
    CAPTURE(steps, position, velocity, fine.position, fine.velocity);
    CHECK(std::abs(position - order) < 0.1);
    CHECK(std::abs(velocity - order) < 0.1);
    if (halving > 0) CHECK(std::abs(position - before) < 0.05);
    CHECK(std::min(fine.position, fine.velocity) > 1e-9);
    before = position;
    coarse = fine;
  }
}

// Starts without symmetry, runs that end at no full period.
template <class Step>
void check_order_everywhere(int order, Step step) {
  SECTION("a push that is not linear and depends on position, velocity and time") {
    const auto pushed = [](double x, double v, double t) {
      return 0.3 - x * x * x - 0.4 * std::abs(v) * v + scenes::sine(1.7 * t) * (1 + 0.2 * x * v);
    };
    check_order(order, step, pushed, State<double>{0.7, -1.1}, 0.4, 500);
  }
  SECTION("a pendulum that swings far") {
    check_order(order, step, scenes::Pendulum<>{.g = 1}, State<double>{1.9, 0.4}, 0.7, 1000);
  }
  SECTION("a planet on an ellipse of eccentricity 0.6") {
    const scenes::Orbit<> planet;
    check_order(order, step, planet, planet.exact(1.3), 0.55, 4000);
  }
  SECTION("a damped oscillator that is driven") {
    const auto driven = [](double x, double v, double t) {
      return -4 * x - 0.2 * v + scenes::cosine(3 * t);
    };
    check_order(order, step, driven, State<double>{0.3, 1.0}, 0.45, 500);
  }
  SECTION("a ball thrown through air") {
    const State<Eigen::Vector2d> start{{1, 2}, {12, 9}};
    check_order(order, step, scenes::QuadraticDrag<>{.k = 0.05}, start, 0.3, 100);
  }
}

}  // namespace

TEST_CASE("Euler has order 1 in position and in velocity") {
  check_order_everywhere(1, measure::euler);
}

TEST_CASE("The exact step of a constant acceleration has order 1 where it is not constant") {
  check_order_everywhere(1, measure::constant_acceleration);
}

TEST_CASE("Symplectic Euler has order 1 in position and in velocity") {
  check_order_everywhere(1, measure::symplectic_euler);
}
