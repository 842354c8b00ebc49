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

Throw pulled(Throw one, const Vec& a) {
  one.a = a;
  return one;
}

Throw running(Throw one, const Vec& runner) {
  one.runner = runner;
  return one;
}

Throw thrown(Throw one, const Vec& from, const Vec& target) {
  one.from = from;
  one.target = target;
  return one;
}

// Of length 1, to any side.
Vec unit(Random& random) {
  const Vec along = random.vector(0.1, 1);
  return along / length(along);
}

struct Mistake {
  const char* says;
  Throw solved;
};

// Steps that sum up a pull allow for a little less of it than there is, or for a little more.
std::string stepped(const Throw& with, const Vec& miss) {
  const Vec way = (0.5 * with.time * with.time) * with.a;
  const double lacking = dot(miss, way) / dot(way, way);
  const double steps = std::abs(1 / lacking);
  if (length(miss - lacking * way) > 1e-9 * length(way)) return "";
  if (!(steps > 1.5 && steps < 1e6 && std::abs(steps - std::round(steps)) < 1e-6 * steps))
    return "";
  return "this allows for the pull in " + number(std::round(steps)) +
         " steps of Euler's method, plain or symplectic; the exact step needs only one";
}

// A mistake is the right answer to another throw, and so that throw meets.
std::vector<std::string> recognise(const Vec& got, const Throw& with) {
  const Vec &a = with.a, &runner = with.runner, standing;
  const double tolerance = with.tolerance().value;
  const std::vector<Mistake> known{
      {"this is right for a ball that nothing pulls: is the pull missing, or multiplied by a 1 / "
       "2, "
       "which is 0 in whole numbers?",
       pulled(with, {})},
      {"half of a, without the time that it pulls", pulled(with, a / with.time)},
      {"the pull works the wrong way round", pulled(with, -a)},
      {"the pull moves a ball by half of h^2 a, not by the whole", pulled(with, 2 * a)},
      {"this is right for a = (0, -9.81, 0), whatever a is", pulled(with, {0, -9.81, 0})},
      {"this is right for a pull straight down; this one pulls to the side, too",
       pulled(with, {0, a.y, 0})},
      {"this hits the place where the runner was at the throw", running(with, standing)},
      {"this is right for a runner who runs the other way", running(with, -runner)},
      {"the runner's velocity is divided by the time, and it needs no division",
       running(with, runner / with.time)},
      {"the runner's way stands here, time times the velocity", running(with, with.time * runner)},
      {"the pull has the time squared, as a place has it; a velocity has it once",
       pulled(with, with.time * a)},
      {"this is right for a throw from the origin: where does the ball start?",
       thrown(with, {}, with.target)},
      {"this is right for a target at the origin", thrown(with, with.from, {})},
      {"from and target are at each other's places", thrown(with, with.target, with.from)},
      {"this adds from to target, where the way is the difference",
       thrown(with, -with.from, with.target)}};
  for (const Mistake& mistake : known) {
    if (length(mistake.solved.miss(got)) <= tolerance) return {mistake.says};
  }
  if (length(with.miss(-got)) <= tolerance) return {"this is minus the right velocity"};
  if (length(with.miss(got / with.time)) <= tolerance)
    return {"this is the way that the ball needs, and not its velocity: time times too much"};
  const double off = length(with.miss(got)) / (with.time * length(got));
  if (like_a_float(off)) return {"right to seven digits and no further: a float?"};
  const std::string steps = stepped(with, with.miss(got));
  return steps.empty() ? std::vector<std::string>{} : std::vector{steps};
}

// From the side; a mate who stands is as tall as one who runs.
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
    finding.diagnoses = recognise(got, with);
    finding.plot = {"The throw, from the side", "x [m]", "y [m]", curves(with, got), true};
  }
  check(finding);
}

}  // namespace

TEST_CASE("a ball lands on a target that stands still", "[1-test-case/throw-to-runner][4 points]") {
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
  for (const double time : harness_bounds::time.asked()) {
    Throw with = drawn();
    with.time = time;
    meets(student, with, "Short or long, a flight is one exact step.");
  }
  const Vec side = unit(random);
  for (const double pull : harness_bounds::a.asked())
    meets(student, pulled(drawn(), pull * side), "A pull may be strong, or none at all.");
  for (const double speed : harness_bounds::runner.asked())
    meets(student, running(drawn(), speed * side), "A runner may be fast, or stand.");
}
