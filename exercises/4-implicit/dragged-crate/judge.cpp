// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <utility>

#include "format_values.h"
#include "judge/describe.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"

using namespace judge;

namespace {

using grade::number;

struct Drag {
  State start;
  double h = 0;
  Vec hand;
  double omega = 0, zeta = 0;

  static Drag draw(Random& random, double angle, double zeta) {
    const Start start = random.start();
    const double h = random.between(0.01, 0.04);
    return {{start.x, start.v}, h, random.vector(-3, 3), angle / h, zeta};
  }

  State by(Student& student) const {
    const auto [x, v] = start;
    const auto n =
        student.call(0, {x.x, x.y, x.z, v.x, v.y, v.z, h, hand.x, hand.y, hand.z, omega, zeta}, 6);
    return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
  }

  // Both lines of the method as two equations for the end, by Cramer's rule:
  // x1 - h v1 = x0,  h omega^2 x1 + (1 + 2 zeta h omega) v1 = v0 + h omega^2 hand.
  State end() const {
    const double pull = h * omega * omega, brake = 1 + 2 * zeta * h * omega;
    const double determinant = brake + h * pull;
    const Vec right = start.v + pull * hand;
    return {(brake * start.x + h * right) / determinant, (right - pull * start.x) / determinant};
  }

  double energy(const State& s) const {
    const Vec off = s.x - hand;
    return (dot(s.v, s.v) + omega * omega * dot(off, off)) / 2;
  }

  Tolerance tolerance() const {
    Tolerance found = rounding((1 + distance(end(), State{}) + length(hand)) / h);
    found.from += "; more by 1/h, since a velocity may be found from two places";
    return found;
  }

  std::string described() const {
    return describe(start, 17) + ", h = " + number(h, 17) + ", hand = " + describe(hand, 17) +
           ", omega = " + number(omega, 17) + ", zeta = " + number(zeta, 17);
  }
};

// What a wrong end often is.
std::vector<std::string> recognised(const Drag& drag, const State& got, double within) {
  if (distance(got, drag.start) == 0) return {"the crate never moves"};
  if (!is_finite(got)) return {"this is not a finite number: a division by zero?"};
  const auto [x, v] = drag.start;
  const double h = drag.h, pull = h * drag.omega * drag.omega;
  const double brake = 2 * drag.zeta * h * drag.omega;
  const Vec pulled = v + pull * (drag.hand - x), kicked = pulled - brake * v;
  Drag at_zero = drag, soft = drag;
  at_zero.hand = {};
  soft.zeta /= 2;
  const auto moved = [&](const Vec& velocity) { return State{x + h * velocity, velocity}; };
  const std::pair<State, const char*> known[] = {
      {{x + h * v, kicked}, "this is Euler's method"},
      {moved(kicked), "this is symplectic Euler: its acceleration is the one of the start"},
      {{x + h * v, drag.end().v}, "the velocity is right; the position moved with the old one"},
      {at_zero.end(), "this is the step of a spring that pulls to zero"},
      {soft.end(), "this is the step of a spring with half the damping"},
      {moved(kicked / (1 + h * pull)), "the damping is the one of the start"},
      {moved(pulled / (1 + brake + pull)), "the divisor has h omega^2 where (h omega)^2 belongs"},
  };
  for (const auto& [end, says] : known) {
    if (distance(got, end) <= within) return {says};
  }
  return {};
}

void ends_right(Student& student, const Drag& drag, const std::string& asked,
                const std::string& hint) {
  const State expected = drag.end(), got = drag.by(student);
  const Tolerance tolerance = drag.tolerance();
  grade::Finding finding = off_by(distance(got, expected), tolerance);
  finding.asked = asked;
  finding.input = drag.described();
  finding.expected = describe(expected);
  finding.got = describe(got);
  if (!finding.held) {
    finding.hint = hint;
    finding.diagnoses = recognised(drag, got, tolerance.value);
  }
  check(finding);
}

}  // namespace

TEST_CASE("the slope at the end leads back to the start", "[4-implicit/dragged-crate][4 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 3; ++n) {
    ends_right(student, Drag::draw(random, random.between(0.5, 4), random.between(0.1, 1.6)),
               "one step after which x = x_old + h v and v = v_old + h a, all new on the right",
               "Every x and v of the acceleration is a new one. Put the new x into it before you "
               "collect.");
  }
}

TEST_CASE("without damping a step divides the energy by 1 + (h omega)^2",
          "[4-implicit/dragged-crate][2 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 3; ++n) {
    const Drag drag = Drag::draw(random, random.between(0.5, 4), 0);
    const double angle = drag.h * drag.omega, expected = 1 + angle * angle;
    // The energy is a square, so what is wrong with the state counts twice.
    const double speed = std::sqrt(2 * drag.energy(drag.start) / expected);
    Tolerance tolerance = drag.tolerance();
    tolerance.value *= 2 * (1 + angle) / speed * expected;
    is_exact("the energy about the hand before the step, over the one after it", drag.described(),
             drag.energy(drag.start) / drag.energy(drag.by(student)), expected, tolerance,
             "Without damping only the pull is left. Does the step square h omega where it "
             "should?");
  }
}

TEST_CASE("a spring far too stiff for the step puts the crate into the hand",
          "[4-implicit/dragged-crate][2 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 3; ++n) {
    ends_right(student,
               Drag::draw(random, std::pow(10, random.between(3, 5)), random.between(0, 1)),
               "one step with h omega above 1000, which no explicit method survives",
               "The larger h omega, the closer the crate must end to the hand. A polynomial "
               "cannot do that; what divides?");
  }
}

TEST_CASE("a spring that is switched off lets the crate go on",
          "[4-implicit/dragged-crate][2 points]") {
  Student student;
  Random random;
  for (const double zeta : {0.0, 0.7}) {
    ends_right(student, Drag::draw(random, 0, zeta), "one step with omega = 0",
               "Without a spring the crate keeps its velocity. Do you divide by omega, or by h "
               "omega?");
  }
}
