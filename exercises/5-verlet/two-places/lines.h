// SPDX-License-Identifier: MIT-0
/// @file
/// Each of the functions alone, and what people write there.
#pragma once
#include <string>
#include <vector>

#include "../places.h"
#include "bounce.h"
#include "judge/random.h"

namespace judge::verlet::two_places {

enum Function { steps, next_place, place_before };

struct Line {
  Vec x, other, a;  ///< the other is x_previous, or v
  double h = 0;

  // So large a step that no term is lost beside another.
  static Line draw() {
    Random random;
    const Start start = random.start();
    return {start.x, start.v, random.vector(2, 9), random.between(0.3, 0.7)};
  }

  /// That one, and the same with the shortest step and with the longest.
  static std::vector<Line> draw_all() {
    std::vector<Line> lines{draw()};
    for (const double h : harness_bounds::h.asked()) {
      lines.push_back(lines[0]);
      lines.back().h = h;
    }
    return lines;
  }

  std::vector<Vec> by(Student& student, Function function) const {
    return as_places(
        student.call(function, {x.x, x.y, x.z, other.x, other.y, other.z, a.x, a.y, a.z, h}, 3));
  }

  Vec next() const { return x + (x - other) + h * h * a; }
  Vec before_start() const { return x - h * other + h * h / 2 * a; }

  std::string in_words(const std::string& name) const {
    return "x = " + describe(x, 17) + ", " + name + " = " + describe(other, 17) +
           ", a = " + describe(a, 17) + ", h = " + grade::number(h, 17);
  }

  Tolerance tolerance() const { return rounding(length(x) + length(other) + length(a)); }
};

inline std::vector<Places> not_next(const Line& line) {
  const auto& [x, before, a, h] = line;
  const Vec far = x + (x - before);
  return {{"where it would be without a push", {far}},
          {"a push of half that size: the half belongs to the start", {far + h * h / 2 * a}},
          {"a push of h instead of h^2", {far + h * a}},
          {"a push to the other side", {far - h * h * a}},
          {"the way back: from x to x_previous and on", {before + (before - x) + h * h * a}},
          {"the last distance taken off instead of added", {before + h * h * a}}};
}

inline std::vector<Places> not_before(const Line& line) {
  const auto& [x, v, a, h] = line;
  return {{"the start of a thing that stood still", {x}},
          {"the way without the push (1 / 2 is 0 in whole numbers): that start has order one",
           {x - h * v}},
          {"twice the push", {x - h * v + h * h * a}},
          {"the push to the other side: h is squared, so its sign is gone",
           {x - h * v - h * h / 2 * a}},
          {"a push of h instead of h^2", {x - h * v + h / 2 * a}},
          {"the place one step after the start", {x + h * v + h * h / 2 * a}}};
}

/// A drag that nobody asked for: less than the whole distance, or more.
inline std::vector<std::string> part_of_distance(const Line& line, const Vec& next) {
  const Vec went = next - line.x - line.h * line.h * line.a, distance = line.x - line.other;
  const double part = dot(went, distance) / dot(distance, distance);
  if (!(length(went - part * distance) <= 1e-10) || !(part > 0) || std::abs(part - 1) <= 1e-10)
    return {};
  return {"the last distance counts " + grade::number(part, 4) + " times"};
}

/// What is wrong with the first two functions, if they are asked alone.
inline std::vector<std::string> first_two_alone() {
  Student fresh;
  const Line line = Line::draw();
  const Vec next = line.by(fresh, next_place)[0], before = line.by(fresh, place_before)[0];
  std::vector<std::string> found;
  const auto add = [&](const std::string& name, const Vec& yours, const Vec& right,
                       const std::vector<Places>& mistakes) {
    if (length(yours - right) <= line.tolerance().value) return;
    auto said = recognised({yours}, {right}, mistakes, line.tolerance());
    if (said.empty() && name == "next_place") said = part_of_distance(line, yours);
    found.push_back(name + (said.empty() ? " is wrong alone, too" : ": " + said[0]));
  };
  add("next_place", next, line.next(), not_next(line));
  add("place_before", before, line.before_start(), not_before(line));
  return found;
}

/// The same of all three.
inline std::vector<std::string> alone() {
  std::vector<std::string> found = first_two_alone();
  Random random;
  for (const double below : {random.between(0.01, 0.1), -0.2}) {
    Student fresh;
    const Spark spark = Spark::draw(random, below);
    const std::string wrong = wrong_with(spark, spark.after(fresh));
    if (!wrong.empty()) found.push_back("bounce: " + wrong);
  }
  return found;
}

}  // namespace judge::verlet::two_places
