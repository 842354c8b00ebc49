// SPDX-License-Identifier: MIT-0
#include "shelf/first_order.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <string>

#include "measure/shelf_card.h"

namespace measure::shelf_cards {
namespace {

using Eigen::Vector2d;

const auto euler = [](auto& x, double t, double h, const auto& u) {
  shelf::first_order_euler(x, t, h, u);
};
const auto midpoint = [](auto& x, double t, double h, const auto& u) {
  shelf::first_order_midpoint(x, t, h, u);
};
const auto rk4 = [](auto& x, double t, double h, const auto& u) {
  shelf::first_order_rk4(x, t, h, u);
};

Vector2d turned(const Vector2d& x, double angle) {
  return {std::cos(angle) * x.x() - std::sin(angle) * x.y(),
          std::sin(angle) * x.x() + std::cos(angle) * x.y()};
}

// A vortex that drifts, turns more slowly further out, and blows in gusts. What it carries goes
// round its centre at one distance.
struct Gusts {
  static Vector2d centre(double t) { return {0.3 * t, std::sin(t)}; }
  static double speed(const Vector2d& from_centre) { return 2 / (1 + from_centre.squaredNorm()); }

  Vector2d operator()(const Vector2d& x, double t) const {
    const Vector2d from_centre = x - centre(t);
    const Vector2d across(-from_centre.y(), from_centre.x());
    return Vector2d(0.3, std::cos(t)) + (speed(from_centre) * (1 + 0.5 * std::cos(2 * t))) * across;
  }
  static Vector2d exact(const Vector2d& start, double t) {
    const Vector2d from_centre = start - centre(0);
    return centre(t) + turned(from_centre, speed(from_centre) * (t + 0.25 * std::sin(2 * t)));
  }
};

template <class Step>
double largest_error(Step step, int steps) {
  const Vector2d start(1.2, -0.4);
  const double h = 3.0 / steps;
  Vector2d x = start;
  double largest = 0;
  for (int n = 0; n < steps; ++n) {
    step(x, n * h, h, Gusts());
    largest = std::max(largest, (x - Gusts::exact(start, (n + 1) * h)).norm());
  }
  return largest;
}

template <class Step>
double order(Step step) {
  return std::log2(largest_error(step, 400) / largest_error(step, 800));
}

Promise orders() {
  const double off = std::max(
      {std::abs(order(euler) - 1), std::abs(order(midpoint) - 2), std::abs(order(rk4) - 4)});
  return {
      "Euler has order 1, midpoint order 2 and RK4 order 4, all to 0.05, in a wind that depends on "
      "place and time",
      off < 0.05, off};
}

template <class Step>
int evaluations(Step step) {
  int asked = 0;
  double x = 1;
  step(x, 0.0, 0.1, [&asked](double now, double) { return ++asked, now; });
  return asked;
}

Promise costs() {
  const int one = evaluations(euler), two = evaluations(midpoint), four = evaluations(rk4);
  return {"in a step Euler asks for u once, midpoint twice and RK4 four times",
          one == 1 && two == 2 && four == 4,
          std::to_string(one) + ", " + std::to_string(two) + ", " + std::to_string(four)};
}

// What one step round a vortex makes of the distance.
template <class Step>
double stretch(Step step, double omega_h) {
  Vector2d x(1, 0);
  step(x, 0.0, omega_h, [](const Vector2d& at, double) { return Vector2d(-at.y(), at.x()); });
  return x.norm();
}

Promise vortex() {
  double off = 0;
  bool within = true;
  for (const double w : {0.1, 0.2, 0.5, 1.0}) {
    off = std::max(off, std::abs(stretch(euler, w) / std::sqrt(1 + w * w) - 1));
    const double out = stretch(midpoint, w) - 1, in = 1 - stretch(rk4, w);
    within = within && out > 0 && out < std::pow(w, 4) / 8 && in > 0 && in < std::pow(w, 6) / 144;
  }
  return {
      "round a vortex, for omega h from 0.1 to 1, Euler flings smoke out by the factor sqrt(1 + "
      "(omega h)^2) in every step; midpoint by less than 1 + (omega h)^4 / 8, and RK4 draws it in "
      "by less than (omega h)^6 / 144",
      within && off < 1e-15, off};
}

Vector2d hares_and_foxes(const Vector2d& now, double) {
  return {now.x() * (1 - now.y()), now.y() * (now.x() - 1)};
}

template <class Step>
double lost(Step step) {
  const auto invariant = [](const Vector2d& now) {
    return now.x() - std::log(now.x()) + now.y() - std::log(now.y());
  };
  constexpr double round = 6.6085;  // to the hundredth of a step
  const Vector2d start(2, 1);
  Vector2d now = start;
  double largest = 0;
  for (int n = 0; n < 1000; ++n) {
    step(now, 0.0, round / 100, hares_and_foxes);
    largest = std::max(largest, std::abs(invariant(now) - invariant(start)));
  }
  return largest;
}

Promise hares() {
  const double rk4s = lost(rk4);
  return {
      "in ten rounds of the hares and foxes of Lotka and Volterra, from (2, 1) at a hundred steps "
      "a "
      "round, RK4 keeps their invariant to 1e-6, midpoint to 2e-3, and Euler loses it by more than "
      "1",
      rk4s < 1e-6 && lost(midpoint) < 2e-3 && lost(euler) > 1, rk4s};
}

template <class Step>
double missed(Step step, double h) {
  const Vector2d start(1.2, -0.4);
  Vector2d x = start;
  step(x, 0.3, h, Gusts());
  step(x, 0.3 + h, -h, Gusts());
  return (x - start).norm();
}

template <class Step>
double order_of_return(Step step) {
  return std::log2(missed(step, 0.04) / missed(step, 0.02));
}

Promise returns() {
  const double off =
      std::max({std::abs(order_of_return(euler) - 2), std::abs(order_of_return(midpoint) - 4),
                std::abs(order_of_return(rk4) - 6)});
  return {
      "a step and the way back, with -h, miss the start by an error of order 2 with Euler, 4 with "
      "midpoint and 6 with RK4, all to 0.1",
      off < 0.1, off};
}

}  // namespace

ShelfCard first_order() {
  return {"first_order", {orders(), costs(), vortex(), hares(), returns()}};
}

}  // namespace measure::shelf_cards
