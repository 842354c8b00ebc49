// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "format_values.h"
#include "harness.h"
#include "judge/diagnose.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"

using namespace judge;

namespace {

using grade::number;

struct Leash {
  double k, c, m;

  double omega() const { return std::sqrt(k / m); }
  double zeta() const { return c / (2 * std::sqrt(k * m)); }
  double fast_rate() const { return (c + std::sqrt(std::max(0.0, c * c - 4 * k * m))) / (2 * m); }
  double limit() const { return zeta() > 1 ? 2 / fast_rate() : c / k; }
};

Leash draw(Random& random, double zeta) {
  const double m = random.between(2, 40), omega = random.between(3, 30);
  return {m * omega * omega, 2 * zeta * m * omega, m};
}

Leash damped(double k, double zeta, double m) {
  return {k, 2 * zeta * std::sqrt(k * m), m};
}

// Each stiffness and each mass that may be asked, with such a damper.
std::vector<Leash> all_damped(double zeta) {
  std::vector<Leash> leashes;
  for (const double k : harness_bounds::k.asked())
    for (const double m : harness_bounds::m.asked()) leashes.push_back(damped(k, zeta, m));
  return leashes;
}

std::string describe(const Leash& leash) {
  return "k = " + number(leash.k, 17) + " N/m, c = " + number(leash.c, 17) +
         " N s/m, m = " + number(leash.m, 17) + " kg; omega = " + number(leash.omega()) +
         "/s, zeta = " + number(leash.zeta());
}

// A leash after a kick that stretches it by about a metre, for sixty steps or until it is too long
// to draw. The kick shows the fast motion, which is the one that explodes.
grade::Curve swing(const std::string& name, const Leash& leash, double h) {
  grade::Curve curve{name, {}, {}};
  double x = 0, v = std::max(leash.omega(), leash.fast_rate());
  for (int n = 0; n <= 60 && std::abs(x) < 20; ++n) {
    curve.x.push_back(n);
    curve.y.push_back(x);
    const double a = -(leash.k * x + leash.c * v) / leash.m;
    x += h * v;
    v += h * a;
  }
  return curve;
}

std::vector<std::string> recognise(double got, const Leash& leash) {
  const double right = leash.limit();
  const auto is = [&](double other) { return std::abs(got / other - 1) < 1e-10; };
  std::vector<std::string> found = diagnose(got, right);
  const double zeta = leash.zeta(), swapped = zeta + std::sqrt(std::abs(zeta * zeta - 1));
  if (leash.c == 0 && got > 0) {
    found = {"without a damper no step holds, however short"};
  } else if (zeta < 1 && (is(4 * leash.m / leash.c) || is(2 / swapped / leash.omega()))) {
    found = {"this is two over a rate, as for a leash that creeps, and this one swings"};
  } else if (zeta > 1 && is(right / 2)) {
    found = {
        "this is one over the fast rate: from there on the leash turns round in every step, and "
        "it explodes from twice that on"};
  } else if (zeta > 1 && is(leash.c / leash.k)) {
    found = {"this is the limit of a leash that swings, and this one creeps"};
  } else if (zeta > 1 && is(2 * leash.c / leash.k - right)) {
    found = {"this is two over the slow rate"};
  } else if (zeta < 1 && is(2 / leash.omega())) {
    found = {"this is 2/omega, the limit of symplectic Euler without damping"};
  } else if (is(Leash{leash.k, leash.c, 1}.limit())) {
    found = {"this is right for a mass of 1 kg"};
  } else if (is(Leash{leash.k, 2 * leash.c, leash.m}.limit())) {
    found = {"this is right for twice the damper: what is zeta?"};
  } else if (is(right * leash.omega())) {
    found = {"this is h omega, and h was asked"};
  } else if (zeta > 100 && std::abs(got / right - 1) < 0.01) {
    found = {"the first digits are right: a difference of nearly equal numbers lost the others"};
  }
  if (got > right * 1.01) found.push_back("with your step this leash explodes");
  if (got >= 0 && got < right * 0.99) found.push_back("longer steps would hold, too");
  return found;
}

void holds_until(Student& student, const Leash& leash, double lost, const std::string& hint) {
  const double got = student.call(0, {leash.k, leash.c, leash.m}, 1)[0];
  const double expected = leash.limit();
  Tolerance tolerance = rounding(expected);
  tolerance.value *= lost;
  if (lost > 1) tolerance.from += ", and what the difference in the formula with zeta may lose";

  grade::Finding finding = off_by(std::abs(got - expected), tolerance);
  finding.asked = "the longest step with which Euler's method holds a leash [s]";
  finding.input = describe(leash);
  finding.expected = number(expected, 12);
  finding.got = number(got, 12);
  finding.error += " s";
  if (!finding.held) {
    finding.hint = hint;
    finding.diagnoses = recognise(got, leash);
    finding.plot = {
        "A leash after a kick",
        "step",
        "stretch [m]",
        {swing("at your step", leash, got), swing("just inside", leash, 0.95 * expected)}};
  }
  check(finding);
}

}  // namespace

TEST_CASE("a leash that swings holds up to the longest step",
          "[2-euler/stiffest-leash][3 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 4; ++n) {
    holds_until(student, draw(random, random.between(0.05, 0.95)), 1,
                "The damper must take out more energy than the method puts in: h omega < 2 zeta.");
  }
  for (const Leash& leash : all_damped(random.between(0.05, 0.95)))
    holds_until(student, leash, 1, "Soft or stiff, light or heavy: the limit is the same formula.");
}

TEST_CASE("a leash that creeps is limited by its fast motion",
          "[2-euler/stiffest-leash][3 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 4; ++n) {
    const double zeta = random.between(1.1, 4), sum = zeta + std::sqrt(zeta * zeta - 1);
    holds_until(student, draw(random, zeta), sum * sum,
                "Two motions die away, and the limit is two over the rate of one of them.");
  }
  const double zeta = random.between(1.1, 4), sum = zeta + std::sqrt(zeta * zeta - 1);
  for (const Leash& leash : all_damped(zeta))
    holds_until(student, leash, sum * sum,
                "Soft or stiff, light or heavy: the limit is the same formula.");
}

TEST_CASE("critical damping belongs to both sides, and no damper has no step",
          "[2-euler/stiffest-leash][2 points]") {
  Student student;
  Random random;
  // Numbers without rounding, so that critical is critical however it is computed.
  const double m = 1 << random.whole(1, 4), omega = random.whole(3, 20);
  holds_until(student, {m * omega * omega, 2 * m * omega, m}, 1,
              "At zeta = 1 both limits are 2/omega. Does one of your roots meet a number below 0?");
  holds_until(
      student, {m * omega * omega, 0, m}, 1,
      "Without a damper nothing takes out what the method puts in, however short the step.");
}

TEST_CASE("a leash like a wall keeps its digits", "[2-euler/stiffest-leash][2 points]") {
  Student student;
  Random random;
  const std::string hint =
      "Far beyond critical damping zeta and its root are nearly equal. Take the limit from the "
      "fast rate, which is a sum.";
  for (int n = 3; n <= 7; ++n)
    holds_until(student, draw(random, std::pow(10, n) * random.between(1, 9)), 1, hint);
  Leash hardest = draw(random, 1);
  hardest.c = harness_bounds::c.largest();
  holds_until(student, hardest, 1, hint);
}
