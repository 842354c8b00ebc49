// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

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

struct Throw {
  Vec from, target, runner, a;
  double time;

  // One exact step, as the task gives it.
  Vec ball(const Vec& v, double t) const { return from + t * v + (0.5 * t * t) * a; }
  Vec meeting() const { return target + time * runner; }
  Vec miss(const Vec& v) const { return meeting() - ball(v, time); }

  Tolerance tolerance() const {
    return rounding(length(from) + length(target) + time * (length(runner) + time * length(a)));
  }
};

Throw draw(Random& random) {
  return {random.vector(-3, 3),
          random.vector(4, 20),
          {},
          {0, -random.between(2, 25), 0},
          random.between(0.4, 2.5)};
}

Vec ask(Student& student, const Throw& one) {
  std::vector<double> numbers;
  for (const Vec& vector : {one.from, one.target, one.runner, one.a}) {
    numbers.insert(numbers.end(), {vector.x, vector.y, vector.z});
  }
  numbers.push_back(one.time);
  const std::vector<double> got = student.call(0, numbers, 3);
  return {got[0], got[1], got[2]};
}

// A throw from anywhere to anywhere, and now and then to where it came from.
Throw anywhere(Random& random, double time) {
  Throw one{random.vector_anywhere(harness_bounds::from),
            random.vector_anywhere(harness_bounds::target),
            random.vector_anywhere(harness_bounds::runner),
            random.vector_anywhere(harness_bounds::a), time};
  const int kind = random.whole(0, 9);
  const double farthest = harness_bounds::from.largest();
  if (kind == 2) {
    one.from = random.vector_anywhere({"from", farthest, farthest});
    one.target = -one.from;
  }
  if (kind < 2) one.target = one.from;
  if (kind == 0) one.runner = {};
  return one;
}

// The paths seen from the side; a mate who stands is as tall as one who runs.
std::vector<grade::Curve> curves(const Throw& with, const Vec& v) {
  grade::Curve ball{"your ball", {}, {}}, mate{"the mate", {}, {}};
  for (int n = 0; n <= 40; ++n) {
    const Vec at = with.ball(v, with.time * n / 40);
    ball.x.push_back(at.x);
    ball.y.push_back(at.y);
  }
  for (const Vec& at : {with.target, with.meeting(), with.meeting() - Vec{0, 1, 0}}) {
    mate.x.push_back(at.x);
    mate.y.push_back(at.y);
  }
  return {ball, mate};
}

void meets(Student& student, const Throw& with, const std::string& hint) {
  const Vec got = ask(student, with);
  grade::Finding finding = off_by(length(with.miss(got)), with.tolerance(), " m");
  finding.asked = "the velocity with which a ball meets the runner";
  finding.input = "from " + describe(with.from, 17) + ", target " + describe(with.target, 17) +
                  ", runner " + describe(with.runner, 17) + ", a = " + describe(with.a, 17) +
                  ", time " + number(with.time, 17);
  finding.expected =
      "the ball at " + describe(with.meeting(), 12) + " when the time is over, as the runner is";
  finding.got = "thrown with your " + describe(got, 12) + " it is at " +
                describe(with.ball(got, with.time), 12);
  if (!finding.held) {
    finding.hint = hint;
    if (!std::isfinite(length(got)))
      finding.diagnoses = {"this is not a finite velocity: a division by zero?"};
    finding.plot = {"The throw, from the side", "x [m]", "y [m]", curves(with, got), true};
  }
  check(finding);
}

}  // namespace

TEST_CASE("a ball lands on a target that stands still", "[1-test-case/throw-to-runner][3 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 3; ++n) {
    meets(student, draw(random), "By how much does the pull alone move the ball in that time?");
  }
}

TEST_CASE("a ball and a runner come to one place", "[1-test-case/throw-to-runner][3 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 3; ++n) {
    Throw with = draw(random);
    with.runner = random.vector(-6, 6);
    meets(student, with, "Aim at where the runner will be, not at where the runner is.");
  }
}

TEST_CASE("a wind from any side is allowed for", "[1-test-case/throw-to-runner][3 points]") {
  Student student;
  Random random;
  const std::string hint = "The acceleration has three components, and each moves the ball.";
  const auto drawn = [&] {
    Throw with = draw(random);
    with.runner = random.vector(-6, 6);
    with.a = with.a + random.vector(-4, 4);
    return with;
  };
  for (int n = 0; n < 3; ++n) meets(student, drawn(), hint);
}

TEST_CASE("any throw meets, however near or far, slow or fast, and two by turns",
          "[1-test-case/throw-to-runner][1 point]") {
  Student student;
  Random random;
  constexpr int pairs = 200, rounds = 2;
  for (int n = 0; n < pairs; ++n) {
    const double time = random.anywhere(harness_bounds::time);
    const Throw one = anywhere(random, time), other = anywhere(random, time);
    for (int round = 0; round < rounds; ++round)
      for (const Throw& with : {one, other})
        meets(student, with,
              "One formula holds for all. Which of these numbers is so large or so small, or which "
              "is 0, that a line of yours does something of its own?");
  }
}
