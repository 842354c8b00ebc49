// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

#include "harness.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "scene.h"

using namespace judge;
using grade::number;

namespace {

// Each entry is a difference of numbers of the size of the matrix and the rest; a root of what is
// left of them loses as much again as the eigenvalues are near each other.
Tolerance told_apart(double largest, double gap) {
  Tolerance tolerance = rounding(20 * (1 + largest * largest) / gap);
  tolerance.from += ", of entries up to 20, and eigenvalues " + number(gap, 2) + " apart";
  return tolerance;
}

void check_growth(Student& student, const hidden::Step& step, double expected, double gap,
                  const std::string& asked, const std::string& hint) {
  const double got = student.call(0, step.arguments(0), 1)[0];
  grade::Finding finding = off_by(std::abs(got - expected), told_apart(expected, gap));
  finding.asked = "the growth of " + asked;
  finding.input = hidden::described(step);
  finding.expected = number(expected, 12);
  finding.got = number(got, 12);
  if (!finding.held) {
    finding.hint = hint;
  }
  check(finding);
}

// Four methods on one spring.
void finds_longest(Student& student, Random& random, double w, double most) {
  const double zeta = random.between(0.05, 0.7);
  for (hidden::Method& method : hidden::methods(w, zeta)) {
    method.step.x_rest = random.between(-2, 2);
    const double expected = std::min(most, method.limit);
    const double got = student.call(1, method.step.arguments(most), 1)[0];
    grade::Finding finding =
        off_by(std::abs(got - expected), {1e-6 * expected, "a millionth was asked for"}, " s");
    finding.asked = "the longest stable step";
    finding.input = method.name + " on a spring with omega = " + number(w, 17) +
                    ", zeta = " + number(zeta, 17) +
                    ", hung at x = " + number(method.step.x_rest, 17) +
                    "; most = " + number(most, 17);
    finding.expected = number(expected, 12) + " s";
    finding.got = number(got, 12) + " s";
    if (!finding.held) {
      finding.hint =
          "Halve the interval between a step that holds and one that does not, and try `most` "
          "before anything else.";
      finding.diagnoses = hidden::what_is_wrong(got, expected, most);
    }
    check(finding);
  }
}

}  // namespace

TEST_CASE("the growth of a step that swings is found",
          "[7-which-to-use/dot-on-the-map][3 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 4; ++n) {
    const double size = random.between(0.6, 1.4), angle = random.between(0.3, 2.8);
    const double a = size * std::cos(angle), b = size * std::sin(angle);
    check_growth(
        student, hidden::with_eigenvalues(random, a, b, true), size, 2 * b, "a step that swings",
        "If the eigenvalues are not real, both have the size of the root of their product. And "
        "did you take the rest away?");
  }
}

TEST_CASE("the growth of a step that does not swing is found, leaps included",
          "[7-which-to-use/dot-on-the-map][3 points]") {
  Student student;
  Random random;
  for (const double sign : {1.0, -1.0, -1.0, 1.0}) {
    const double larger = sign * random.between(0.8, 1.6), smaller = random.between(-0.5, 0.5);
    check_growth(
        student, hidden::with_eigenvalues(random, larger, smaller, false), std::abs(larger),
        std::abs(larger - smaller),
        larger < 0 ? "a step that leaps from side to side" : "a step that creeps",
        "Of two real eigenvalues the one farther from zero counts, whatever its sign. And did "
        "you take the rest away?");
  }
  const std::string hint = "Does the formula divide by an entry, or take one for not zero?";
  for (const auto& [step, growth] : hidden::simple())
    check_growth(student, step, growth, 0.5, "a step with zeros in its matrix", hint);
}

TEST_CASE("the longest stable step of four methods is right to a millionth",
          "[7-which-to-use/dot-on-the-map][3 points]") {
  Student student;
  Random random;
  const double w = random.between(2, 30);
  finds_longest(student, random, w, random.between(5, 6) / w);
}

TEST_CASE("the longest stable step is right on the softest spring and the stiffest, for any `most`",
          "[7-which-to-use/dot-on-the-map][1 point]") {
  Student student;
  Random random;
  constexpr int springs = 100;
  for (int n = 0; n < springs; ++n) {
    const double most = random.anywhere(harness_bounds::most);
    finds_longest(student, random, random.octaves(0.01, 1e6) / most, most);
  }
}
