// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "harness.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "scene.h"

using namespace judge;
using namespace sledge;
using grade::number;

namespace {

grade::Finding compare(const Ride& ride, const State& yours, const State& expected,
                       const Tolerance& tolerance) {
  grade::Finding finding = off_by(distance(yours, expected), tolerance);
  finding.input = ride.input();
  finding.expected = describe(expected);
  finding.got = describe(yours);
  return finding;
}

void takes_steps(Student& student, const Ride& ride) {
  const auto yours = ride.by(student), expected = ride.by_method();
  for (std::size_t step = 0; step < yours.size(); ++step) {
    grade::Finding finding =
        compare(ride, yours[step], expected[step],
                rounding(ride.steps, ride.size() + distance(expected[step], State{})));
    finding.asked = "step " + std::to_string(step + 1) + " under a hidden push";
    if (!finding.held) {
      finding.hint =
          "Push first, then divide each part of the velocity by its own 1 + c h, then move.";
    }
    check(finding);
  }
}

}  // namespace

TEST_CASE("a few steps of a sledge are braked after the push, by division",
          "[6-symplectic/sledge-that-grips][3 points]") {
  Student student;
  Random random;
  const auto takes = [&](const Sledge& sledge, double h, int steps) {
    takes_steps(student, {sledge, random.start(), random.wild(), h, steps});
  };
  const auto some = [&] { return random.between(0.05, 0.3); };
  for (int n = 0; n < 2; ++n) {
    const double h = some();
    takes(Sledge::draw(random), h, 5);
  }
}

TEST_CASE("any step is braked after the push, however long, however hard each brake, from anywhere",
          "[6-symplectic/sledge-that-grips][1 point]") {
  Student student;
  Random random;
  constexpr int rides = 600;
  for (int n = 0; n < rides; ++n) takes_steps(student, Ride::anywhere(random));
}

TEST_CASE("pulled at a rope a sledge ends at one speed, however long the step",
          "[6-symplectic/sledge-that-grips][3 points]") {
  Student student;
  Random random;
  const Sledge drawn = Sledge::draw(random);
  const double g = random.between(3, 12);
  const Vec pull{0, -g, 0}, glide = dot(pull, drawn.along) * drawn.along;
  const Vec expected = glide / drawn.c_along + (pull - glide) / drawn.c_across;
  for (const double ch : {0.1, 1.0, 10.0, 1000.0}) {
    const double h = ch / drawn.c_along;
    // Steps enough that less than a rounding is missing of the final speed.
    const int steps =
        static_cast<int>(std::log(1 / std::numeric_limits<double>::epsilon()) / std::log1p(ch)) + 1;
    const Ride ride{drawn, random.start(), {harness::Force::falling, {g}}, h, steps, steps};
    const Vec yours = ride.by(student).back().v;
    grade::Finding finding =
        compare(ride, {{}, yours}, {{}, expected}, rounding(1, 1 + length(expected)));
    finding.asked = std::to_string(steps) + " steps under a pull of " + number(g, 17) +
                    " m/s^2 along -y, with c h = " + number(ch) + " along the runners";
    finding.expected = "v = " + describe(expected);
    finding.got = "v = " + describe(yours);
    if (!finding.held) {
      finding.hint =
          "When the speed is final, one push and one brake together change nothing. "
          "Which factor does that ask for after the push?";
    }
    check(finding);
  }
}

TEST_CASE("a braked spring lets go at 2 (sqrt(1 + zeta^2) + zeta), and not before",
          "[6-symplectic/sledge-that-grips][3 points]") {
  Student student;
  Random random;
  const double zeta = random.between(0.2, 1);
  is_stable_until(
      student, zeta, 2 * (std::sqrt(1 + zeta * zeta) + zeta),
      "Divided after the push, a brake gives room; divided before it, or as a force, it "
      "takes room away. (The spring's drag is the same in all directions here.)",
      1);
}
