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

// A leash of this stiffness and mass: with any damper, or as far from critical damping as may be,
// or near it on either side.
Leash any_leash(Random& random, double k, double m) {
  constexpr double nearest = 1e-13, least = 1e-6, most = 1e8;  // of zeta
  Leash leash{k, random.anywhere(harness_bounds::c), m};
  const int kind = random.whole(0, 5);
  if (kind == 3) leash.c = random.octaves(1e-9, 1e3);
  if (kind == 4) leash.c = random.whole(0, 1) == 0 ? k : m;
  if (kind == 1) leash = damped(k, random.octaves(least, most), m);
  if (kind == 2 || kind == 5) leash = damped(k, random.nearly_one(nearest, 0.9), m);
  leash.c = std::min(leash.c, harness_bounds::c.largest());
  return leash;
}

// Just beyond critical damping the fast rate has a root of a difference of nearly equal numbers,
// whichever way it is computed.
double lost_in_the_root(const Leash& leash) {
  const double zeta = leash.zeta();
  return zeta > 1 ? 1 / std::sqrt(1 - 1 / (zeta * zeta)) : 1;
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

std::vector<std::string> what_is_wrong(double got, double right) {
  std::vector<std::string> found = diagnose(got, right);
  if (got > right * 1.01) found.push_back("with your step this leash explodes");
  if (got >= 0 && got < right * 0.99) found.push_back("longer steps would hold, too");
  return found;
}

void holds_until(Student& student, const Leash& leash, double lost, const std::string& hint) {
  const double got = student.call(0, {leash.k, leash.c, leash.m}, 1)[0];
  const double expected = leash.limit();
  Tolerance tolerance = rounding(expected);
  tolerance.value *= lost;
  if (lost > 1) tolerance.from += ", and what the difference in the formula may lose";

  grade::Finding finding = off_by(std::abs(got - expected), tolerance);
  finding.asked = "the longest step with which Euler's method holds a leash [s]";
  finding.input = describe(leash);
  finding.expected = number(expected, 17);
  finding.got = number(got, 17);
  finding.error += " s";
  if (!finding.held) {
    finding.hint = hint;
    finding.diagnoses = what_is_wrong(got, expected);
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
          "[2-euler/stiffest-leash][2 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 4; ++n) {
    holds_until(student, draw(random, random.between(0.05, 0.95)), 1,
                "The damper must take out more energy than the method puts in: h omega < 2 zeta.");
  }
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

TEST_CASE("any leash is right, soft or stiff, light or heavy, and two by turns",
          "[2-euler/stiffest-leash][1 point]") {
  Student student;
  Random random;
  constexpr int pairs = 200, rounds = 2;
  for (int n = 0; n < pairs; ++n) {
    const double k = random.anywhere(harness_bounds::k);
    // Now and then as many kilograms as newtons a metre.
    const double m =
        n % 10 == 0 ? std::min(k, harness_bounds::m.largest()) : random.anywhere(harness_bounds::m);
    const Leash one = any_leash(random, k, m);
    // Now and then only the damper is another, or only the mass.
    const int alike = random.whole(0, 2);
    const double other_m = alike == 0 ? m : random.anywhere(harness_bounds::m);
    Leash other = any_leash(random, k, other_m);
    if (alike == 1) other.c = one.c;
    for (int round = 0; round < rounds; ++round)
      for (const Leash& leash : {one, other})
        holds_until(
            student, leash, lost_in_the_root(leash),
            "Two formulas hold for all leashes, one on each side of critical damping. Which "
            "of these numbers is so small or so large that a line of yours does something "
            "of its own?");
  }
}
