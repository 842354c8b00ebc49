// SPDX-License-Identifier: MIT-0
#include "shelf/soft_constraint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "measure/shelf_card.h"

namespace measure::shelf_cards {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double h = 1 / 60.0;
constexpr auto times = [](double p, double q) { return p * q; };

// A thing on a joint to a wall, each step begun with the impulse of the last.
struct Jointed {
  double x, v, impulse = 0, wall = 0;

  void step(double length, const shelf::Softness<double>& soft) {
    shelf::soft_warm_start(wall, v, impulse, 1.0, 0.0, 1.0);
    shelf::soft_constraint(wall, v, impulse, 1.0, x, 0.0, 1.0, soft, times);
    x = x + length * v;
  }
};

Promise numbers() {
  long double off = 0;
  const auto compare = [&](double found, long double wanted) {
    off = std::max(off, std::abs(found - wanted) / wanted / epsilon);
  };
  for (int power = -6; power <= 3; ++power) {
    for (const double zeta : {0.0, 1e-4, 0.3, 1.0, 10.0}) {
      const double omega = std::pow(10, power) / h;
      const auto soft = shelf::softness(h, omega, zeta);
      const long double angle = (long double)h * omega, stiff = angle * (2 * zeta + angle);
      compare(soft.bias_rate, omega / (2 * zeta + angle));
      compare(soft.mass_scale, stiff / (1 + stiff));
      compare(soft.impulse_scale, 1 / (1 + stiff));
    }
  }
  return {"the three numbers are right to 4 roundings, for h omega from 10^-6 to 1000", off < 4,
          double(off), 2, "roundings"};
}

Promise warm_starts() {
  double off = 0;
  for (const double omega : {0.1, 6.0, 60.0, 600.0}) {
    const auto soft = shelf::softness(h, omega, 0.3);
    const auto solved = [&](double warm, int solves) {
      double v1 = 1, v2 = -4, impulse = warm;
      shelf::soft_warm_start(v1, v2, warm, 1.0, 0.5, 2.0);
      for (; solves > 0; --solves) {
        shelf::soft_constraint(v1, v2, impulse, 1.0, 0.05, 0.5, 2.0, soft, times);
      }
      return v2 - v1;
    };
    for (const double warm : {-30.0, -1.0, 0.0, 0.7, 500.0}) {
      for (const int solves : {1, 2, 3}) {
        const double speeds = 5 + std::abs(2.5 * warm);
        off = std::max(off, std::abs(solved(warm, solves) - solved(0, 1)) / speeds / epsilon);
      }
    }
  }
  return {
      "from any warm start one solve ends at the same velocities, to 8 roundings of the speeds "
      "that the warm start gives, and so do two and three",
      off < 8, off, 2, "roundings"};
}

// The swings of a run in a second, by where it passes zero, or its damping, by the area between two
// steps in the plane of x and v: what no step of an undamped motion changes.
struct Seen {
  double hertz, zeta;
};

Seen seen(int rate) {
  const double length = 1.0 / rate;
  const auto soft = shelf::softness(length, 10 * std::numbers::pi, 0.0);
  Jointed one{1, 0}, other{0, 1};
  one.step(length, soft);
  other.step(length, soft);
  const double half_trace = (one.x + other.v) / 2, area = one.x * other.v - one.v * other.x;
  const double swing = std::acos(half_trace / std::sqrt(area)), decay = -std::log(area) / 2;
  return {swing * rate / (2 * std::numbers::pi), decay / std::hypot(swing, decay)};
}

bool shown_as(double found, double said, double last_digit) {
  return std::abs(found - said) <= last_digit / 2;
}

Promise frequency() {
  return {
      "what was asked for as 5 Hz swings at 3.86 Hz with 30 steps a second, at 4.61 with 60 and "
      "at 4.97 with 240",
      shown_as(seen(30).hertz, 3.86, 0.01) && shown_as(seen(60).hertz, 4.61, 0.01) &&
          shown_as(seen(240).hertz, 4.97, 0.01),
      seen(60).hertz, 3, "Hz"};
}

Promise damping() {
  return {"its damping ratio then is 0.42, 0.24 and 0.065, where none was asked for",
          shown_as(seen(30).zeta, 0.42, 0.01) && shown_as(seen(60).zeta, 0.24, 0.01) &&
              shown_as(seen(240).zeta, 0.065, 0.001),
          seen(60).zeta};
}

Promise motion() {
  double off = 0;
  for (const double angle : {1e-3, 0.1, 0.5, 3.0, 100.0}) {
    for (const double zeta : {0.0, 0.2, 0.7, 2.0}) {
      const auto soft = shelf::softness(h, angle / h, zeta);
      const auto real = shelf::soft_motion(h, angle / h, zeta);
      Jointed jointed{1, 0};
      double before = jointed.x;
      jointed.step(h, soft);
      double now = jointed.x;
      const double turn = real.omega * h * std::sqrt(std::abs(1 - real.zeta * real.zeta));
      const double left = std::exp(-real.zeta * real.omega * h);
      const double sum = 2 * left * (real.zeta < 1 ? std::cos(turn) : std::cosh(turn));
      for (int n = 1; n < 100; ++n) {
        const double next = sum * now - left * left * before;
        before = now, now = next;
        jointed.step(h, soft);
        off = std::max(off, std::abs(jointed.x - now));
      }
    }
  }
  return {"soft_motion gives the places of 100 steps of a constraint, to 10^-12 of the first",
          off < 1e-12, off, 2, "of the first"};
}

Promise bounded() {
  double most = 0;
  for (int power = -6; power <= 6; ++power) {
    const auto soft = shelf::softness(h, std::pow(10, power) / h, 0.0);
    Jointed jointed{1, 0};
    for (int n = 0; n < 1000; ++n) {
      jointed.step(h, soft);
      most = std::max(most, std::abs(jointed.x));
    }
  }
  return {"however large h omega is, up to 10^6, an undamped stretch with no speed never grows",
          most <= 1, most, 3, "of the first"};
}

}  // namespace

ShelfCard soft_constraint() {
  return {"soft_constraint",
          {numbers(), warm_starts(), frequency(), damping(), motion(), bounded()}};
}

}  // namespace measure::shelf_cards
