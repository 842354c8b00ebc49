// SPDX-License-Identifier: MIT-0
/// @file
/// One step with drag, and which drag it was.
#pragma once
#include <cmath>
#include <string>

#include "../places.h"
#include "harness.h"
#include "judge/random.h"

namespace judge::verlet::braked_verlet {

struct Line {
  Vec x, before, a;
  double c = 0, h = 0;

  /// A step in which 1 - c h is below zero, which some cut off.
  static Line draw() {
    Random random;
    const double h = random.between(0.2, 0.3);
    return {random.start().x, random.start().x, random.vector(2, 9), random.between(1.2, 1.8) / h,
            h};
  }

  /// Any step that may be asked: at rest, far away, hardly braked or hardly pushed; one in eight
  /// with c h = 2, at which the last distance counts for nothing.
  static Line anywhere(Random& random) {
    Line line{random.vector_anywhere(harness_bounds::place),
              random.vector_anywhere(harness_bounds::place),
              random.vector_anywhere(harness_bounds::a), random.anywhere(harness_bounds::c),
              random.anywhere(harness_bounds::h)};
    if (random.whole(0, 7) == 0) {
      line.h = std::ldexp(1.0, -random.whole(0, 5));
      line.c = 2 / line.h;
    }
    return line;
  }

  Vec by(Student& student) const {
    return as_vectors(student.call(1, as_numbers(x, before, a, c, h), 3))[0];
  }

  double tolerance() const {
    return rounding(length(x) + length(before) + h * h * length(a)).value;
  }

  /// The velocity from the place before to the place after.
  Vec velocity(const Vec& next) const { return (next - before) / (2 * h); }

  std::string in_words() const {
    return named("x", x, "x_previous", before, "a", a, "c", c, "h", h);
  }
};

/// The place and the velocity that it makes fit both formulas of the task.
inline void solves(Student& student, const Line& line) {
  const Vec next = line.by(student), v = line.velocity(next);
  const Vec other_side = line.x + (line.x - line.before) + line.h * line.h * (line.a - line.c * v);
  grade::Finding finding =
      off_by(length(next - other_side), {line.tolerance(), rounding(1).from}, " m");
  finding.asked = "next_place";
  finding.input = line.in_words();
  finding.expected = "a place that the two formulas of the task give back";
  finding.got = describe(next, 12) + ", which makes v " + describe(v) +
                ", and with that the right side is " + describe(other_side, 12);
  if (!finding.held) {
    finding.hint = "Put your result into the two formulas of the task. Do both sides agree?";
  }
  check(finding);
}

}  // namespace judge::verlet::braked_verlet
