// SPDX-License-Identifier: MIT-0
/// @file
/// A spark at the floor, and what is left of its velocity.
#pragma once
#include "../places.h"
#include "harness.h"
#include "judge/random.h"

namespace judge::verlet::two_places {

struct Spark {
  Vec x, x_previous;
  double floor = 0, restitution = 0;

  /// Falls, and is so far below the floor; above it, if that is less than nothing.
  static Spark draw(Random& random, double below) {
    Spark spark{random.start().x, {}, 0, random.between(0.3, 0.9)};
    spark.x_previous = spark.x + Vec{random.between(-0.2, 0.2), random.between(0.2, 0.5),
                                     random.between(-0.2, 0.2)};
    spark.floor = spark.x.y + below;
    return spark;
  }

  /// Was below the floor a step ago already, as when the floor rises.
  static Spark overtaken(Random& random) {
    Spark spark = draw(random, 0.01);
    spark.floor = spark.x_previous.y + random.between(0.05, 0.2);
    return spark;
  }

  /// The same at another height.
  Spark on(double other) const {
    Spark spark = *this;
    spark.floor = other;
    spark.x.y += other - floor;
    spark.x_previous.y += other - floor;
    return spark;
  }

  Vec distance() const { return x - x_previous; }

  Spark after(Student& student) const {
    const std::vector<Vec> two = as_places(student.call(
        3, {x.x, x.y, x.z, x_previous.x, x_previous.y, x_previous.z, floor, restitution}, 6));
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
    return moved ? (before.x.y > before.floor
                        ? "it is not below the floor, and was moved all the same"
                        : "it lies on the floor, which is not below it, and was moved all the same")
                 : "";
  }
  if (length(after.x - before.x) + length(after.x_previous - before.x_previous) == 0)
    return before.x_previous.y < before.floor
               ? "both of its places are below the floor, and it was left there"
               : "it is below the floor, and was left there";
  if (alike(after.x.y - before.floor, before.floor - before.x.y))
    return "the spark was put as far above the floor as it was below: it should lie on it";
  if (!alike(after.x.y, before.floor)) return "the spark does not lie on the floor";
  const bool sideways = alike(after.x.x, before.x.x) && alike(after.x.z, before.x.z) &&
                        alike(left.x, came.x) && alike(left.z, came.z);
  if (!sideways) return "sideways nothing should change, neither the place nor the distance";
  if (alike(left.y + before.restitution * came.y, 0)) return "";
  if (length(after.x_previous - before.x_previous) == 0)
    return "this is a spark that was lifted: x_previous was left where it was";
  if (alike(left.y, came.y)) return "this is a spark that still falls";
  if (alike(left.y, before.restitution * came.y)) return "this is a spark that falls on, slower";
  if (alike(left.y + came.y, 0))
    return "this is a spark that loses nothing: the restitution is missing";
  if (alike(left.y, before.restitution * (before.x_previous.y - before.floor)))
    return "it flies off by its way to the floor, and not by the last distance: was that worked "
           "out "
           "after the spark was lifted?";
  if (alike(left.y, std::sqrt(before.restitution) * -came.y))
    return "this is the square root of the restitution, as if it were a share of the energy";
  return "it flies off with another speed than the one that it fell with, times the restitution";
}

inline void bounces(Student& student, const Spark& before) {
  const Spark after = before.after(student);
  const std::string wrong = wrong_with(before, after);
  const bool below = before.x.y < before.floor;
  grade::Finding finding;
  finding.held = wrong.empty();
  finding.asked = below ? "a bounce of a spark below the floor" : "no bounce above the floor";
  finding.input = "x = " + describe(before.x, 17) +
                  ", x_previous = " + describe(before.x_previous, 17) +
                  ", floor = " + grade::number(before.floor, 17) +
                  ", restitution = " + grade::number(before.restitution, 17);
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
    Student fresh;
    const bool remembers = wrong_with(before, before.after(fresh)).empty();
    finding.diagnoses = {remembers ? "alone this bounce comes out right: something is remembered "
                                     "from one spark to the next"
                                   : wrong};
  }
  check(finding);
}

}  // namespace judge::verlet::two_places
