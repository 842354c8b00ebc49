// SPDX-License-Identifier: MIT-0
/// @file
/// A leaf that falls, and for which there is a formula.
///
/// Runs whose errors follow C h^p.
#pragma once
#include <algorithm>
#include <cmath>

#include "harness.h"
#include "judge/method.h"
#include "judge/random.h"

/// The errors of a falling leaf when it is stepped: the largest of four seconds [m].
struct Leaf {
  harness::Force force;
  judge::Start start;
  double duration = 4;

  static Leaf draw(judge::Random& random) {
    return {{harness::Force::falling, {random.between(5, 12), random.between(0.8, 1.6)}},
            {random.vector(1, 3), random.vector(-2, 2), 0}};
  }

  double height_at(double t) const {
    const double g = force.a[0], c = force.a[1], last = -g / c;
    return start.x.y + last * t + (start.v.y - last) * (1 - std::exp(-c * t)) / c;
  }

  double error(const judge::Method& method, int steps) const {
    const double h = duration / steps;
    const judge::Path path = judge::run(method, start, h, steps, 1, force);
    double largest = 0;
    for (std::size_t n = 1; n < path.states.size(); ++n) {
      largest = std::max(largest, std::abs(path.states[n].x.y - height_at(path.time(n))));
    }
    return largest;
  }
};

namespace runs {

struct Runs {
  double h1, error1, h2, error2;

  double order() const { return std::log(error1 / error2) / std::log(h1 / h2); }
};

/// Returns whether a value can be asked.
inline bool is_within(const harness::Bounds& bounds, double value) {
  return value >= bounds.smallest() && value <= bounds.largest();
}

/// A value that is about this one, or not at all: at most half apart, and down to a millionth.
inline double about(judge::Random& random, double value, double apart) {
  const double side = random.sign();
  return value + side * random.octaves(1e-6, 0.5) * apart;
}

/// Two runs of any steps and errors; now and then with a step of a half or about that, or an order
/// that is nearly whole. The finer run has the smaller error.
inline Runs any_runs(judge::Random& random, double h1) {
  const auto& p = harness_bounds::p;
  constexpr double nearest =
      1.05;  // at a smaller quotient of the steps little is left of its digits
  for (;;) {
    Runs two{h1, random.anywhere(harness_bounds::error1), random.anywhere(harness_bounds::h2),
             random.anywhere(harness_bounds::error2)};
    if (random.whole(0, 3) == 0) two.h2 = h1 / 2;
    if (random.whole(0, 3) == 0) two.h2 = about(random, h1 / 2, h1 / 4);
    if (random.whole(0, 2) == 0) {
      const double order = about(random, random.whole(1, 7), 1);
      two.error2 = two.error1 * std::pow(two.h2 / h1, order);
    }
    if (is_within(harness_bounds::h2, two.h2) && is_within(harness_bounds::error2, two.error2) &&
        h1 > nearest * two.h2 && is_within(p, two.order()))
      return two;
  }
}

/// A run, its order, and the error that it should have had.
struct Wanted {
  double wanted, h, error, p;

  double error_with(double step, double order) const { return error * std::pow(step / h, order); }
};

/// Any error from any run, now and then nearly the one that it has, or of nearly a whole order.
inline Wanted any_wanted(judge::Random& random, double h) {
  Wanted ask{random.anywhere(harness_bounds::wanted), h, random.anywhere(harness_bounds::error),
             random.anywhere(harness_bounds::p)};
  if (random.whole(0, 3) == 0) ask.p = about(random, random.whole(1, 7), 1);
  if (random.whole(0, 3) == 0) ask.wanted = about(random, ask.error, ask.error);
  ask.wanted = std::min(ask.wanted, harness_bounds::wanted.largest());
  ask.wanted = std::max(ask.wanted, harness_bounds::wanted.smallest());
  return ask;
}

/// The duration of a run whose steps are at most so long; now and then nearly a whole number of
/// them, and never so nearly that rounding can choose. Only a few are of very many: who counts them
/// one by one takes long for those.
inline double any_duration(judge::Random& random, double h) {
  constexpr double nearest = 1e-7, many = 1e5;
  const bool may_be_many = random.whole(0, 9) == 0;
  for (;;) {
    double duration = random.anywhere(harness_bounds::duration);
    if (random.whole(0, 1) == 0) duration = about(random, random.whole(1, 20000), 1) * h;
    const double steps = duration / h;
    const bool is_exact = h == 1;
    if (is_within(harness_bounds::duration, duration) && (may_be_many || steps <= many) &&
        (is_exact || std::abs(steps - std::round(steps)) > nearest))
      return duration;
  }
}

}  // namespace runs
