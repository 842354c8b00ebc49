// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "format_values.h"
#include "judge/describe.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "scene.h"

using namespace judge;
using namespace judge::dragged_crate;

namespace {

using grade::number;

void meets_its_lines(Student& student, const Drag& drag, const std::string& asked,
                     const std::string& hint) {
  const State end = drag.by(student);
  const Tolerance tolerance = drag.tolerance();
  grade::Finding finding = off_by(drag.miss(end), tolerance, " m/s");
  finding.asked = asked;
  finding.input = drag.described();
  finding.expected = "x = x_old + h v and v = v_old + h a, all of it taken at your end";
  finding.got = describe(end) + "; there x_old + h v is " +
                describe(drag.start.x + drag.h * end.v) + ", and v_old + h a is " +
                describe(drag.start.v + drag.h * drag.acceleration(end.x, end.v));
  if (!finding.held) {
    finding.diagnoses = what_is_wrong(drag, end);
    finding.hint = hint;
  }
  check(finding);
}

// The distance of an end from a change of the right length along what the spring asks for.
double velocity_error(const Drag& drag, const State& end) {
  const Vec change = end.v - drag.start.v, towards = drag.asked_for();
  const double along = dot(change, towards) / length(towards);
  const Vec moved = (end.x - drag.start.x) / drag.h - end.v;
  return larger(length(moved), larger(std::abs(along - drag.h * drag.strongest),
                                      length(change - along / length(towards) * towards)));
}

void goes_on(Student& student, const Drag& drag, const std::string& asked,
             const std::string& hint) {
  const State end = drag.by(student);
  const auto [x, v] = drag.start;
  const Tolerance tolerance = rounding((1 + length(x) + length(v)) / drag.h);
  grade::Finding finding = off_by(distance(end, {x + drag.h * v, v}), tolerance);
  finding.asked = asked;
  finding.input = drag.described();
  finding.expected = "the old velocity, and h times that on";
  finding.got = describe(end);
  if (!finding.held) {
    finding.diagnoses = what_is_wrong(drag, end);
    finding.hint = hint;
  }
  check(finding);
}

void ends_right(Student& student, const Drag& drag) {
  const State end = drag.by(student);
  const Tolerance tolerance = drag.tolerance_of_end();
  grade::Finding finding = off_by(drag.apart(end), tolerance, " m/s");
  finding.asked = "one step of one of many crates, each with a hand and a spring of its own";
  finding.input = drag.described();
  finding.expected = describe(drag.right());
  finding.got = describe(end);
  finding.error += ", with the place over h";
  if (!finding.held) {
    finding.diagnoses = what_is_wrong(drag, end);
    finding.hint =
        "Is the crate at rest, in the hand, or beside it along an axis here, or a number so small "
        "or so large that a line of yours does something of its own?";
  }
  check(finding);
}

}  // namespace

TEST_CASE("with a strong hand the slope at the end leads back to the start",
          "[4-implicit/dragged-crate][2 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 3; ++n) {
    const double zeta = random.between(0.1, 1.6), angle = random.between(0.5, 4);
    const Drag drag = Drag::draw(random, angle, zeta);
    meets_its_lines(
        student, drag,
        "one step after which x = x_old + h v and v = v_old + h a, all new on the right",
        "Every x and v of the acceleration is a new one. Put the new x into it before you "
        "collect.");
  }
}

TEST_CASE("a weak hand changes the velocity by as much as it can, in the same direction",
          "[4-implicit/dragged-crate][3 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 3; ++n) {
    const double zeta = random.between(0.1, 1.6), angle = random.between(0.5, 4);
    Drag drag = Drag::draw(random, angle, zeta);
    drag.strongest = random.between(0.1, 0.5) * length(drag.asked_for()) / drag.divisor() / drag.h;
    const State end = drag.by(student);
    const Tolerance tolerance = drag.tolerance();
    grade::Finding finding = off_by(velocity_error(drag, end), tolerance, " m/s");
    finding.asked = "one step with a hand that gives at most half of what the spring asks for";
    finding.input = drag.described();
    finding.expected = "a change of velocity of " + number(drag.h * drag.strongest) +
                       " m/s along " + describe(drag.asked_for() / length(drag.asked_for()));
    const Vec change = end.v - drag.start.v;
    finding.got = describe(end) + ", a change of " + number(length(change)) + " m/s";
    if (!finding.held) {
      finding.hint =
          "Work out the new velocity of a strong hand first. How far is it from the old one, and "
          "which way?";
      finding.diagnoses = what_is_wrong(drag, end);
    }
    check(finding);
  }
}

TEST_CASE("without damping a step divides the energy by 1 + (h omega)^2",
          "[4-implicit/dragged-crate][1 point]") {
  Student student;
  Random random;
  for (int n = 0; n < 3; ++n) {
    const Drag drag = Drag::draw(random, random.between(0.5, 4), 0);
    const auto energy = [&](const State& s) {
      const Vec far = s.x - drag.hand;
      return (dot(s.v, s.v) + drag.omega * drag.omega * dot(far, far)) / 2;
    };
    const State end = drag.by(student);
    // The energy is a square, so what is wrong with the state counts twice.
    Tolerance tolerance = drag.tolerance();
    tolerance.value *= 4 * drag.divisor() / std::sqrt(2 * energy(drag.start) / drag.divisor());
    is_exact("the energy about the hand before the step, over the one after it", drag.described(),
             energy(drag.start) / energy(end), drag.divisor(), tolerance,
             "Without damping only the pull is left. Does the step square h omega where it "
             "should?");
  }
}

TEST_CASE("a spring far too stiff for the step puts the crate into a strong hand",
          "[4-implicit/dragged-crate][1 point]") {
  Student student;
  Random random;
  for (int n = 0; n < 3; ++n) {
    const double zeta = random.between(0, 1), power = random.between(3, 5);
    meets_its_lines(student, Drag::draw(random, std::pow(10, power), zeta),
                    "one step with h omega above 1000, which no explicit method survives",
                    "The larger h omega, the closer the crate must end to the hand. A polynomial "
                    "cannot do that; what divides?");
  }
}

TEST_CASE("a spring that is switched off lets the crate go on",
          "[4-implicit/dragged-crate][1 point]") {
  Student student;
  Random random;
  for (const double zeta : {0.0, 0.7}) {
    goes_on(student, Drag::draw(random, 0, zeta), "one step with omega = 0",
            "Without a spring the crate keeps its velocity. Do you divide by omega, or by h "
            "omega?");
  }
}

TEST_CASE("a hand without strength lets the crate go on, and a crate at rest in it stays there",
          "[4-implicit/dragged-crate][1 point]") {
  Student student;
  Random random;
  Drag drag = Drag::draw(random, random.between(0.5, 4), 0.7);
  drag.strongest = 0;
  const std::string hint =
      "Here the change that the spring asks for, or the one that the hand can give, is zero. Do "
      "you divide by one of them?";
  goes_on(student, drag, "one step with strongest = 0", hint);
  Drag rests = Drag::draw(random, random.between(0.5, 4), 0.7);
  rests.start = {rests.hand, {}};
  goes_on(student, rests, "one step of a crate that rests in the hand", hint);
  rests.strongest = 0;
  goes_on(student, rests, "the same with strongest = 0", hint);
}

TEST_CASE("any hand moves any crate, however strong, stiff, near or far",
          "[4-implicit/dragged-crate][1 point]") {
  Student student;
  Random random;
  constexpr int crates = 500;
  for (int n = 0; n < crates; ++n) ends_right(student, Drag::anywhere(random));
}
