// SPDX-License-Identifier: MIT-0
/// @file
/// A crate, a hand, and how far a step is from the two lines of backward Euler.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "harness.h"
#include "judge/describe.h"
#include "judge/numbers.h"
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

  /// Anything that may be asked: at rest, in the hand, along an axis, strong or weak. One in four
  /// hands is just as strong as it must be, or nearly.
  static Drag anywhere(Random& random) {
    Drag drag;
    drag.start = {random.vector_anywhere(harness_bounds::place),
                  random.vector_anywhere(harness_bounds::velocity)};
    drag.h = random.anywhere(harness_bounds::h);
    drag.hand =
        random.whole(0, 3) > 0 ? random.vector_anywhere(harness_bounds::hand) : drag.start.x;
    drag.omega = random.anywhere(harness_bounds::omega);
    drag.zeta = random.anywhere(harness_bounds::zeta);
    drag.strongest = random.anywhere(harness_bounds::strongest);
    if (random.whole(0, 3) == 0)
      drag.strongest = random.nearly_one(1e-9, 0.5) * length(drag.change_of_strong()) / drag.h;
    return drag;
  }

  State by(Student& student) const {
    const auto numbers = as_numbers(start, h, hand, omega, zeta, strongest);
    return as_states(student.call(0, numbers, 6))[0];
  }

  Vec acceleration(const Vec& x, const Vec& v) const {
    return omega * omega * (hand - x) - 2 * zeta * omega * v;
  }

  /// The amount by which a step misses that it moves with one velocity and is kicked at one state
  /// [m/s].
  double miss(const State& end, const Vec& moves_with, const Vec& x, const Vec& v) const {
    const Vec moved = (end.x - start.x) / h - moves_with;
    const Vec kicked = end.v - start.v - h * acceleration(x, v);
    return larger(length(moved), length(kicked));
  }

  /// The miss of backward Euler: all of it at the end.
  double miss(const State& end) const { return miss(end, end.v, end.x, end.v); }

  /// The change that the spring asks for, times 1 + 2 zeta h omega + (h omega)^2.
  Vec asked_for() const { return h * acceleration(start.x + h * start.v, start.v); }

  double divisor() const { return 1 + 2 * zeta * h * omega + (h * omega) * (h * omega); }

  Vec change_of_strong() const { return asked_for() / divisor(); }

  State right() const {
    const Vec wanted = change_of_strong();
    const double size = length(wanted), most = h * strongest;
    const Vec v = start.v + (size > most ? most / size * wanted : wanted);
    return {start.x + h * v, v};
  }

  /// The distance of an end from the right one, the position by the velocity that it takes to get
  /// there [m/s].
  double apart(const State& end) const {
    return larger(length(end.x - right().x) / h, length(end.v - right().v));
  }

  /// The tolerance of that: whoever finds the position first has a velocity as exact as a position
  /// over h.
  Tolerance tolerance_of_end() const {
    return rounding((length(start.x) + length(hand)) / h + 2 * length(start.v));
  }

  /// The tolerance of a miss: each of an end's numbers is a double, so that its lines cannot be met
  /// better than to the rounding of what they add up. They are the right end's: one's own might be
  /// as large as one likes.
  Tolerance tolerance() const {
    const double fastest = length(start.v) + length(asked_for()) / divisor();
    const double places = 2 * length(start.x) + h * fastest + length(hand);
    const double velocities = length(start.v) + fastest;
    return rounding(places / h + velocities + h * omega * (omega * places + 2 * zeta * velocities));
  }

  std::string described() const {
    return named("x", start.x, "v", start.v, "h", h, "hand", hand, "omega", omega, "zeta", zeta,
                 "strongest", strongest);
  }
};

/// Diagnoses that hold of any wrong end.
inline std::vector<std::string> what_is_wrong(const Drag& drag, const State& end) {
  if (!is_finite(end)) return {"this is not a finite number: a division by zero?"};
  if (distance(end, drag.start) == 0) return {"the crate never moves"};
  if (length(end.v - drag.right().v) <= drag.tolerance_of_end().value)
    return {"the velocity is right, and the place is not x_old + h v"};
  return {};
}

}  // namespace judge::dragged_crate
