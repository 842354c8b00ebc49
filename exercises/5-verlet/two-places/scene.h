// SPDX-License-Identifier: MIT-0
/// @file
/// The arguments of each function, and a spark at the floor.
#pragma once
#include <string>
#include <vector>

#include "../places.h"
#include "harness.h"
#include "judge/random.h"

namespace judge::verlet::two_places {

enum Function { steps, next_place, place_before };

struct Line {
  Vec x, other, a;  ///< the other is x_previous, or v
  double h = 0;

  // A line with so large a step that no term is lost beside another.
  static Line draw() {
    Random random;
    const Start start = random.start();
    return {start.x, start.v, random.vector(2, 9), random.between(0.3, 0.7)};
  }

  /// The drawn line, and any that may be asked: at rest and with nothing that pushes, too.
  static std::vector<Line> draw_all(Function function) {
    constexpr int count = 200;
    std::vector<Line> lines{draw()};
    Random random;
    for (int n = 0; n < count; ++n) {
      Line line{random.vector_anywhere(harness_bounds::place),
                random.vector_anywhere(harness_bounds::velocity),
                random.vector_anywhere(harness_bounds::a), random.anywhere(harness_bounds::h)};
      if (function == next_place) line.other = line.x - line.h * line.other;
      lines.push_back(line);
    }
    return lines;
  }

  std::vector<Vec> by(Student& student, Function function) const {
    return as_vectors(student.call(function, as_numbers(x, other, a, h), 3));
  }

  Vec next() const { return x + (x - other) + h * h * a; }
  Vec before_start() const { return x - h * other + h * h / 2 * a; }

  std::string in_words(const std::string& name) const {
    return named("x", x, name, other, "a", a, "h", h);
  }

  Tolerance tolerance() const { return rounding(length(x) + length(other) + length(a)); }
};

struct Spark {
  Vec x, x_previous;
  double floor = 0, restitution = 0;

  /// A spark that falls, and is so far below the floor; above it, if that is less than nothing.
  static Spark draw(Random& random, double below) {
    Spark spark{random.start().x, {}, 0, random.between(0.3, 0.9)};
    spark.x_previous = spark.x + Vec{random.between(-0.2, 0.2), random.between(0.2, 0.5),
                                     random.between(-0.2, 0.2)};
    spark.floor = spark.x.y + below;
    return spark;
  }

  /// A spark that was below the floor a step ago already, as when the floor rises.
  static Spark overtaken(Random& random) {
    Spark spark = draw(random, 0.01);
    spark.floor = spark.x_previous.y + random.between(0.05, 0.2);
    return spark;
  }

  /// A spark deep below any floor or hardly below, upon it, above it; some rise.
  static Spark anywhere(Random& random) {
    constexpr harness::Bounds below{"below", -100, 100, 0}, distance{"distance", 0, 300};
    Spark spark;
    spark.floor = random.anywhere(harness_bounds::floor);
    spark.restitution = random.anywhere(harness_bounds::restitution);
    spark.x = random.vector_anywhere(harness_bounds::place);
    spark.x.y = spark.floor - random.anywhere(below);
    if (spark.floor == 0 && random.whole(0, 1) == 0) spark.x = {0, -random.octaves(1e-15, 1e-6), 0};
    Vec came = random.vector_anywhere(distance);
    if (random.whole(0, 3) > 0) came.y = -std::abs(came.y);
    spark.x_previous = spark.x - came;
    return spark;
  }

  Vec distance() const { return x - x_previous; }

  Spark after(Student& student) const {
    const auto numbers = as_numbers(x, x_previous, floor, restitution);
    const std::vector<Vec> two = as_vectors(student.call(3, numbers, 6));
    return {two[0], two[1], floor, restitution};
  }

  double tolerance() const { return rounding(length(x) + length(x_previous) + 1).value; }
};

/// The first thing that is wrong with a spark after its bounce; empty if nothing is.
inline std::string wrong_with(const Spark& before, const Spark& after) {
  const auto alike = [&](double a, double b) { return std::abs(a - b) <= before.tolerance(); };
  const Vec came = before.distance(), left = after.distance();
  if (before.x.y >= before.floor) {
    const bool moved =
        length(after.x - before.x) + length(after.x_previous - before.x_previous) > 0;
    return moved ? "it is not below the floor, and was moved all the same" : "";
  }
  if (!alike(after.x.y, before.floor)) return "the spark does not lie on the floor";
  const bool sideways = alike(after.x.x, before.x.x) && alike(after.x.z, before.x.z) &&
                        alike(left.x, came.x) && alike(left.z, came.z);
  if (came.y > 0) return "";  // what it does next is nowhere said
  if (!sideways) return "sideways nothing should change, neither the place nor the distance";
  return alike(left.y + before.restitution * came.y, 0)
             ? ""
             : "it flies off with another speed than the one that it fell with, times the "
               "restitution";
}

inline void bounces(Student& student, const Spark& before) {
  const Spark after = before.after(student);
  const std::string wrong = wrong_with(before, after);
  const bool below = before.x.y < before.floor;
  grade::Finding finding;
  finding.held = wrong.empty();
  const std::string far = grade::number(std::abs(before.floor - before.x.y), 3);
  finding.asked = below ? "a bounce of a spark " + far + " m below the floor"
                        : "no bounce of a spark " + far + " m above the floor";
  finding.input = named("x", before.x, "x_previous", before.x_previous, "floor", before.floor,
                        "restitution", before.restitution);
  finding.expected = below
                         ? "x on the floor, and from x_previous to x the last distance, up instead "
                           "of down and times the restitution"
                         : "both places as they were";
  finding.got = "x = " + describe(after.x, 12) + ", x_previous = " + describe(after.x_previous, 12);
  finding.error = "from x_previous to x it was " + describe(before.distance(), 6) +
                  ", and is now " + describe(after.distance(), 6);
  finding.tolerance = grade::number(below ? before.tolerance() : 0, 2);
  finding.tolerance_from = below ? rounding(1).from : "nothing should be touched";
  if (!finding.held) {
    finding.hint =
        "Work out the last distance before you move anything. What should it be afterwards, and "
        "where must x_previous lie so that it is?";
    finding.diagnoses = {wrong};
  }
  check(finding);
}

}  // namespace judge::verlet::two_places
