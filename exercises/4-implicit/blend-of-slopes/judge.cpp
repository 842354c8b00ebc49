// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "format_values.h"
#include "harness.h"
#include "judge/describe.h"
#include "judge/diagnose.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"

using namespace judge;

namespace {

using grade::number;
using Rate = std::complex<double>;

enum Function { brake, swing, longest, least };

double ask(Student& student, Function function, double a, double b = 0, double c = 0) {
  return student.call(function, {a, b, c}, 1)[0];
}

Rate factor(double theta, Rate z) {
  return (1.0 + (1 - theta) * z) / (1.0 - theta * z);
}

// Exact where it has only one part, which not every library's is.
Rate root_of(double number) {
  return number < 0 ? Rate(0, std::sqrt(-number)) : Rate(std::sqrt(number));
}

// Values of each decade, from the largest down, then its bounds and what is special. The smallest
// come last: there most ways are alike.
std::vector<double> decades(Random& random, const harness::Bounds& bounds) {
  std::vector<double> values;
  for (double high = bounds.largest(); high > 9 * bounds.smallest(); high /= 10)
    values.push_back(high * random.between(0.2, 1));
  for (const double asked : bounds.asked()) values.push_back(asked);
  return values;
}

struct Spring {
  double theta, omega, zeta;

  Rate lambda(double sign) const { return omega * (-zeta + sign * root_of(zeta * zeta - 1)); }

  // The factor by which the worse of its two motions grows in a step.
  double growth(double h) const {
    return std::max(std::abs(factor(theta, h * lambda(1))),
                    std::abs(factor(theta, h * lambda(-1))));
  }

  // The step up to which the square of the factor's numerator is no larger than that of its
  // denominator, for the one lambda and the other. From one half on it never is.
  double longest() const {
    double found = INFINITY;
    for (const double sign : {1, -1}) {
      const Rate rate = lambda(sign);
      if (theta < 0.5)
        found = std::min(found, 2 * std::abs(rate.real()) / std::norm(rate) / (1 - 2 * theta));
    }
    return found;
  }

  // Just above critical damping the root of zeta^2 - 1 is rounded by as much more as it is smaller.
  Tolerance tolerance() const {
    if (!std::isfinite(longest()) || longest() == 0) return {0, "there is nothing to round"};
    const double root = zeta > 1 ? std::sqrt(zeta * zeta - 1) : 1;
    return rounding(longest() * (1 + 1 / root));
  }

  std::string described() const {
    return named("theta", theta) + ", " + named("omega", omega) + ", " + named("zeta", zeta);
  }
};

void holds_until(Student& student, const Spring& spring) {
  const double expected = spring.longest();
  const double got = ask(student, longest, spring.theta, spring.omega, spring.zeta);
  const double off = got == expected ? 0 : std::abs(got - expected);

  grade::Finding finding = off_by(off, spring.tolerance());
  finding.asked = "the longest step at which a spring does not grow";
  finding.input = spring.described();
  finding.expected = number(expected, 12);
  finding.got = number(got, 12);
  if (!finding.held) {
    finding.hint =
        "What are the spring's two lambda here, and what does the condition say of "
        "each? Which way does it turn when theta passes one half?";
    finding.diagnoses = diagnose(got, expected);
    if (std::isnan(got) && spring.theta == 0.5)
      finding.diagnoses.emplace_back("with theta = 1/2 this divides by 1 - 2 theta, which is zero");
    if (got == 0 && spring.theta < 0.5)
      finding.diagnoses.emplace_back("only without any damping does a spring grow at every step");
    if (got < 0)
      finding.diagnoses.emplace_back("no step is negative: is this the formula for another theta?");
    if (std::isfinite(got) && got > 0) {
      finding.diagnoses.emplace_back(std::string(got < expected ? "too short" : "too long") +
                                     ": a step a thousandth shorter than yours multiplies by " +
                                     number(spring.growth(0.999 * got), 8) +
                                     ", one a thousandth longer by " +
                                     number(spring.growth(1.001 * got), 8));
    }
  }
  check(finding);
}

void brakes(Student& student, double theta, double ch) {
  is_exact("what one step leaves of a velocity on a brake",
           named("theta", theta) + ", " + named("c h", ch), ask(student, brake, theta, ch),
           factor(theta, -ch).real(), rounding((1 + ch) / (1 + theta * ch)),
           "A brake has lambda = -c, and the share of the end stands in the divisor. Long "
           "steps turn the velocity round, and the sign tells.");
}

void swings(Student& student, double theta, double homega) {
  const double expected = std::abs(factor(theta, Rate(0, homega)));
  is_exact("what one step leaves of the swing of an undamped spring",
           named("theta", theta) + ", " + named("h omega", homega),
           ask(student, swing, theta, homega), expected, rounding(expected),
           "An undamped spring has lambda = i omega. The swing goes with the size of R, which "
           "is a root of two squares.");
}

// Checks the least theta, which is one half while its factor is still positive, up to c h = 2.
void stops(Student& student, double ch) {
  is_exact("the least theta, from one half on, that does not turn a brake round", named("c h", ch),
           ask(student, least, ch), ch > 2 ? (ch - 1) / ch : 0.5, rounding(1),
           "Where is the numerator of R zero? And which theta may the dial not go below?");
}

// Anything between the bounds, one in three times near to what is special.
double any_near(Random& random, const harness::Bounds& bounds, double special) {
  if (random.whole(0, 2) > 0) return random.anywhere(bounds);
  const double away = random.octaves(1e-9, 0.2);
  const double near = random.whole(0, 1) == 1 ? special + away : special - away;
  return std::min(near, bounds.largest());
}

double any_theta(Random& random) {
  return any_near(random, harness_bounds::theta, random.whole(0, 1) == 1 ? 0.5 : 1);
}

}  // namespace

TEST_CASE("a brake keeps what the factor says, with its sign",
          "[4-implicit/blend-of-slopes][2 points]") {
  Student student;
  Random random;
  for (const double theta : random.all_of(harness_bounds::theta, 1)) {
    for (const double ch : decades(random, harness_bounds::c_h)) {
      brakes(student, theta, ch);
    }
  }
}

TEST_CASE("an undamped spring keeps what the factor says",
          "[4-implicit/blend-of-slopes][2 points]") {
  Student student;
  Random random;
  for (const double theta : random.all_of(harness_bounds::theta, 1)) {
    for (const double homega : decades(random, harness_bounds::omega_h)) {
      swings(student, theta, homega);
    }
  }
}

TEST_CASE("just below the longest step a damped spring shrinks, just above it grows",
          "[4-implicit/blend-of-slopes][3 points]") {
  Student student;
  Random random;
  const double below = random.between(0.1, 0.9), above = random.between(1.2, 2.9);
  for (const double theta : {random.between(0.05, 0.4), random.between(0.6, 0.9), 0.0, 0.5, 1.0}) {
    for (const double zeta : {below, above, 0.0, 1.0})
      holds_until(student, {theta, random.between(1, 30), zeta});
  }
}

TEST_CASE("the least theta brakes to a stop and no further",
          "[4-implicit/blend-of-slopes][2 points]") {
  Student student;
  Random random;
  for (const double ch : decades(random, harness_bounds::c_h)) {
    stops(student, ch);
  }
}

TEST_CASE("the dial is right at every theta, for every brake and spring, however near to another",
          "[4-implicit/blend-of-slopes][1 point]") {
  Student student;
  Random random;
  constexpr int scenes = 250;
  for (int n = 0; n < scenes; ++n) {
    const double c_h = random.anywhere(harness_bounds::c_h);
    brakes(student, any_theta(random), c_h);
    const double omega_h = random.anywhere(harness_bounds::omega_h);
    swings(student, any_theta(random), omega_h);
    holds_until(student, {any_theta(random), random.anywhere(harness_bounds::omega),
                          any_near(random, harness_bounds::zeta, 1)});
    stops(student, any_near(random, harness_bounds::c_h, 2));
  }
}
