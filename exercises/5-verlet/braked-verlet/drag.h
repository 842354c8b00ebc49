// SPDX-License-Identifier: MIT-0
/// @file
/// One step with drag, and which drag it was.
#pragma once
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "../places.h"
#include "harness.h"
#include "judge/diagnose.h"
#include "judge/random.h"

namespace judge::verlet::braked_verlet {

struct Line {
  Vec x, before, a;
  double c = 0, h = 0;

  /// Such that 1 - c h is below zero, which some cut off.
  static Line draw() {
    Random random;
    const double h = random.between(0.2, 0.3);
    return {random.start().x, random.start().x, random.vector(2, 9), random.between(1.2, 1.8) / h,
            h};
  }

  /// The same with each bound of the drag, and with each of the step.
  std::vector<Line> at_the_bounds() const {
    std::vector<Line> lines;
    for (const double drag : harness_bounds::c.asked()) {
      lines.push_back(*this);
      lines.back().c = drag;
    }
    for (const double step : harness_bounds::h.asked()) {
      lines.push_back(*this);
      lines.back().h = step;
    }
    return lines;
  }

  Vec by(Student& student) const {
    return as_places(
        student.call(1, {x.x, x.y, x.z, before.x, before.y, before.z, a.x, a.y, a.z, c, h}, 3))[0];
  }

  double tolerance() const {
    return rounding(length(x) + length(before) + h * h * length(a)).value;
  }

  /// The deceleration by which a place differs from the one without drag [m/s^2].
  Vec drag_of(const Vec& next) const { return (x + (x - before) + h * h * a - next) / (h * h); }

  /// From the place before to the place after.
  Vec velocity(const Vec& next) const { return (next - before) / (2 * h); }

  bool is_drag(const Vec& next, const Vec& drag) const {
    return h * h * length(drag_of(next) - drag) <= tolerance();
  }

  /// What people take for the drag, if this was their place.
  std::vector<std::pair<const char*, Vec>> mistakes(const Vec& next) const {
    const Vec v = velocity(next), ago = (x - before) / h, ahead = (next - x) / h;
    const Vec pushed = velocity(next - h * h * a), divided = (next + x - before) / (2 * h);
    const double rest = -std::expm1(-c * h) / h;
    const double over = 1 + c * h / 2;
    const Vec only_push = x + (x - before) + h * h / over * a;
    const Vec half_of_before = (2 * x - before + h * h * a) / over;
    const Vec distance = (x - before) / (h * h), later = (next - x) / (2 * h);
    return {
        {"this is position Verlet without drag: is c left out, or is a half written as 1 / 2, "
         "which "
         "is 0 in whole numbers?",
         {}},
        {"this is position Verlet with the drag of half a step ago, as in the chapter", c * ago},
        {"this is drag at the velocity of half a step ahead: x_next - x over h", c * ahead},
        {"this is drag with the wrong sign: it drives", -c * v},
        {"this is drag without the step: c for c h", c / h * v},
        {"the drag counts twice: from the place before to the place after it is two steps",
         2 * c * v},
        {"the drag counts half: one half too many", c / 2 * v},
        {"the push is missing", c * v + a},
        {"the push counts with the wrong sign", c * v + 2 * a},
        {"the push counts with h instead of h^2", c * v + a - a / h},
        {"the push counts half: that half belongs to the start", c * v + a / 2},
        {"the last distance is missing", c * later + distance},
        {"the last distance counts with the wrong sign: x_previous and x are swapped in it",
         c * (later - h / 2 * distance) + 2 * distance},
        {"x and x_previous are swapped", c * later + 3 * distance},
        {"only half of the drag is here, the half that is known", c / 2 * ago},
        {"only half of the drag is here, the half that is divided", c / 2 * ahead},
        {"only the push is divided by 1 + c h / 2; the last distance has a factor of 1, and "
         "nothing brakes it",
         drag_of(only_push)},
        {"on the right x_previous has a half of the drag, too: c h / 2 times it",
         drag_of(half_of_before)},
        {"the push is not divided", c * pushed},
        {"everything is divided, the place along with it", c * divided},
        {"the factor 1 - c h is cut off at zero: all of the last distance is gone", ago / h},
        {"this is exp(-c h) on the distance alone: stable a little further, and of order one",
         rest * ago},
        {"this is exact drag under a constant force: a good method, and another than was asked "
         "for",
         rest * ago + (1 - rest / c) * a},
    };
  }

  /// What there is to say of the student's step.
  std::vector<std::string> recognised(Student& student) const {
    const Vec next = by(student);
    for (const auto& [says, drag] : mistakes(next)) {
      if (is_drag(next, drag)) return {says};
    }
    Line heavier = *this;
    heavier.c *= 2;
    if (length(heavier.by(student) - next) == 0)
      return {"twice the c gives the same place: the drag does not know it"};
    const double off = h * h * length(drag_of(next) - c * velocity(next));
    if (like_a_float(off))
      return {"right to seven digits and no further: a float, or a constant with an f?"};
    return {};
  }

  std::string in_words() const {
    return "x = " + describe(x, 17) + ", x_previous = " + describe(before, 17) +
           ", a = " + describe(a, 17) + ", c = " + grade::number(c, 17) +
           ", h = " + grade::number(h, 17);
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
    finding.diagnoses = line.recognised(student);
  }
  check(finding);
}

}  // namespace judge::verlet::braked_verlet
