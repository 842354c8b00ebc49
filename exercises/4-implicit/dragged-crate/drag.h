// SPDX-License-Identifier: MIT-0
/// @file
/// A crate, a hand, and how far a step is from the two lines of backward Euler.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "format_values.h"
#include "harness.h"
#include "judge/describe.h"
#include "judge/random.h"
#include "judge/rounding.h"
#include "judge/student.h"

namespace judge::dragged_crate {

struct Drag {
  State start;
  double h = 0;
  Vec hand;
  double omega = 0, zeta = 0;
  double strongest = harness_bounds::strongest.largest();

  static Drag draw(Random& random, double angle, double zeta) {
    const Start start = random.start();
    const double h = random.between(0.01, 0.04);
    return {{start.x, start.v}, h, random.vector(-3, 3), angle / h, zeta};
  }

  /// One for each bound and each special value of the step, of the damping and of the spring that
  /// pulls.
  static std::vector<Drag> at_the_bounds(Random& random) {
    std::vector<Drag> drags;
    const auto add = [&](double h, double omega, double zeta) {
      drags.push_back(draw(random, 0, zeta));
      drags.back().h = h;
      drags.back().omega = omega;
    };
    for (const double h : harness_bounds::h.asked())
      add(h, random.between(0.5, 4) / h, random.between(0.1, 1.6));
    for (const double zeta : harness_bounds::zeta.asked()) add(0.02, random.between(25, 200), zeta);
    add(0.01, harness_bounds::omega.largest(), random.between(0.1, 1.6));
    return drags;
  }

  State by(Student& student) const {
    const auto [x, v] = start;
    const auto n = student.call(
        0, {x.x, x.y, x.z, v.x, v.y, v.z, h, hand.x, hand.y, hand.z, omega, zeta, strongest}, 6);
    return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
  }

  Vec acceleration(const Vec& x, const Vec& v) const {
    return omega * omega * (hand - x) - 2 * zeta * omega * v;
  }

  /// By how much a step misses that it moves with one velocity and is kicked at one state [m/s].
  double miss(const State& end, const Vec& moves_with, const Vec& x, const Vec& v) const {
    const Vec moved = (end.x - start.x) / h - moves_with;
    const Vec kicked = end.v - start.v - h * acceleration(x, v);
    return larger(length(moved), length(kicked));
  }

  /// Of backward Euler: all of it at the end.
  double miss(const State& end) const { return miss(end, end.v, end.x, end.v); }

  /// The change that the spring asks for, times 1 + 2 zeta h omega + (h omega)^2.
  Vec asked_for() const { return h * acceleration(start.x + h * start.v, start.v); }

  double divisor() const { return 1 + 2 * zeta * h * omega + (h * omega) * (h * omega); }

  /// Each of an end's numbers is a double, so that its lines cannot be met better than to the
  /// rounding of what they add up. They are the right end's: one's own might be as large as one
  /// likes.
  Tolerance tolerance() const {
    const double fastest = length(start.v) + length(asked_for()) / divisor();
    const double places = 2 * length(start.x) + h * fastest + length(hand);
    const double velocities = length(start.v) + fastest;
    return rounding(places / h + velocities + h * omega * (omega * places + 2 * zeta * velocities));
  }

  std::string described() const {
    return describe(start, 17) + ", h = " + grade::number(h, 17) +
           ", hand = " + describe(hand, 17) + ", omega = " + grade::number(omega, 17) +
           ", zeta = " + grade::number(zeta, 17) + ", strongest = " + grade::number(strongest, 17);
  }
};

}  // namespace judge::dragged_crate
