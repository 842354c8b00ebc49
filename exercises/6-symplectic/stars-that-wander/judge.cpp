// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "harness.h"
#include "judge/rounding.h"
#include "remarks.h"
#include "scene.h"

using namespace judge;
using namespace stars;
using grade::number;

namespace {

void takes(Student& student, const Stars& start, double h, int steps) {
  const auto yours = by(student, start, h, steps), expected = by_method(start, h, steps);
  const Tolerance tolerance = rounding(steps, 3 + size(start, h));
  for (std::size_t n = 0; n < yours.size(); ++n) {
    grade::Finding finding =
        asked("step " + std::to_string(n + 1) + " of " + std::to_string(start.mu.size()) +
                  (start.mu.size() > 1 ? " stars" : " star"),
              start, h);
    compare(yours[n], expected[n], tolerance.value, finding);
    finding.tolerance_from = tolerance.from;
    if (!finding.held) {
      finding.hint = "Which stars come out right, and what have they in common?";
      finding.diagnoses = what_is_wrong(yours[0], expected[0]);
    }
    check(finding);
  }
}

}  // namespace

TEST_CASE("a few steps of hidden stars are those of symplectic Euler",
          "[6-symplectic/stars-that-wander][2 points]") {
  Student student;
  Random random;
  const double h = random.between(0.1, 0.2);
  takes(student, draw(random, random.whole(3, 5)), h, 4);
  // Many are close to each other, so that a step must be short.
  for (const double count : harness_bounds::stars.asked())
    takes(student, draw(random, static_cast<int>(count)), 0.01, 1);
}

TEST_CASE(
    "a step of any few stars is symplectic Euler's, heavy or light, near or far, fast or still",
    "[6-symplectic/stars-that-wander][1 point]") {
  Student student;
  Random random;
  constexpr int groups = 200;
  for (int n = 0; n < groups; ++n) {
    const double h = random.anywhere(harness_bounds::h);
    takes(student, draw_anywhere(random, random.whole(1, 5)), h, 1);
  }
}

TEST_CASE("two stars that turn around each other stay where they are together",
          "[6-symplectic/stars-that-wander][2 points]") {
  Student student;
  Random random;
  const Stars start = draw_pair(random);
  const double h = random.between(0.01, 0.02);
  constexpr int steps = 2000;
  const auto yours = by(student, start, h, steps);
  grade::Finding finding =
      asked(std::to_string(steps) + " steps of two stars that together do not move", start, h);
  const Stars right = by_method(start, h, 1)[0];
  check_kicks(start, yours[0], right, finding);
  const Tolerance tolerance = rounding(steps, length(start.at[0].v) + length(start.at[1].v));
  double fastest = 0;
  grade::Curve path{"the middle of your stars", {}, {}};
  Vec middle;
  for (const Stars& now : yours) {
    const Vec moving = drift(now);
    fastest = std::isfinite(dot(moving, moving)) ? std::max(fastest, length(moving)) : INFINITY;
    middle += h * moving;
    path.x.push_back(middle.x);
    path.y.push_back(middle.y);
  }
  finding.held = fastest <= tolerance.value;
  finding.expected = "the sum of mass times velocity stays zero";
  finding.got = "the pair moves at up to " + number(fastest) + " m/s";
  finding.error = number(fastest, 3) + " m/s";
  finding.tolerance = number(tolerance.value, 2) + " m/s";
  finding.tolerance_from = tolerance.from;
  if (!finding.held) {
    finding.hint =
        "Two pulls cancel if both are computed from the same two places, and each from "
        "the other's mass.";
    finding.diagnoses = what_is_wrong(yours[0], right);
    finding.plot = {"Where the pair goes", "x [m]", "y [m]", {path}, true};
  }
  check(finding);
}

TEST_CASE("the order of the stars in the list makes no difference",
          "[6-symplectic/stars-that-wander][2 points]") {
  Student student;
  Random random;
  const Stars start = draw(random, 4);
  const double h = random.between(0.1, 0.2);
  grade::Finding finding = asked("one step, and one with the list turned round", start, h);
  const Stars first = by(student, start, h, 1)[0];
  const Stars right = by_method(start, h, 1)[0];
  check_kicks(start, first, right, finding);
  const Tolerance tolerance = rounding(1, 3);
  compare(turned_round(by(student, turned_round(start), h, 1)[0]), first, tolerance.value, finding);
  finding.expected += ", as in the first order";
  finding.got += ", in the other";
  finding.tolerance_from = tolerance.from;
  if (!finding.held) {
    finding.hint = "Does what a star feels depend on whose turn it was before?";
    finding.diagnoses = what_is_wrong(first, right);
  }
  check(finding);
}

TEST_CASE("a step keeps the sum of the areas", "[6-symplectic/stars-that-wander][3 points]") {
  Student student;
  Random random;
  const Stars start = draw(random, 3);
  const Aside a = draw_aside(random, 3), b = draw_aside(random, 3);
  const double h = random.between(0.1, 0.2);
  const auto yours = [&](const Stars& from) { return by(student, from, h, 1)[0]; };
  const auto right = [&](const Stars& from) { return by_method(from, h, 1)[0]; };
  grade::Finding finding =
      asked("one step of three stars, and of those a little beside them", start, h);
  check_kicks(start, yours(start), right(start), finding);
  constexpr double share = 1e-4;
  const auto area_after = [&](const auto& step, double part) {
    return area(start.mu, carried(step, start, a, part), carried(step, start, b, part));
  };
  const double before = area(start.mu, a, b), after = area_after(yours, share);
  // Twice the share shows four times the error of the differences.
  const double curved = std::abs(area_after(right, 2 * share) - area_after(right, share)) / 3;
  const double tolerance = 10 * curved + rounding(1, 10).value / share;
  finding.held = std::abs(after - before) <= tolerance;
  finding.expected = "the sum of mass times area is what it was: " + number(before, 10);
  finding.got = number(after, 10);
  finding.error = number(after - before, 3);
  finding.tolerance = number(tolerance, 2);
  finding.tolerance_from =
      "ten times what differences of " + number(share) + " m miss on the right step, and rounding";
  if (!finding.held) {
    finding.hint =
        "A kick that looks at places and changes velocities keeps the sum, and so does a "
        "drift; each of all stars at once.";
    finding.diagnoses = what_is_wrong(yours(start), right(start));
  }
  check(finding);
}
