// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "format_values.h"
#include "judge/describe.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"

using namespace judge;

namespace {

using grade::number;

struct Throw {
  Vec from, target, runner, a;
  double time;

  Vec velocity() const { return (target - from) / time + runner - 0.5 * time * a; }
  Vec place(const Vec& v, double t) const { return from + t * v + (0.5 * t * t) * a; }
  double miss(const Vec& v) const { return length(place(v, time) - (target + time * runner)); }

  // The longest of the terms that a right answer sums.
  double size() const {
    return (length(from) + length(target)) / time + length(runner) + length(a) * time;
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

struct Mistake {
  const char* says;
  Vec velocity;
};

std::vector<std::string> recognise(const Vec& got, const Throw& with, double tolerance) {
  const Vec right = with.velocity(), pull = with.time * with.a;
  const std::vector<Mistake> known{
      {"this is right for a ball that nothing pulls", right + 0.5 * pull},
      {"the pull works the wrong way round", right + pull},
      {"the pull moves a ball by half of h^2 a, not by the whole", right - 0.5 * pull},
      {"this hits the place where the runner was at the throw", right - with.runner},
      {"this is right for a runner who runs the other way", right - 2 * with.runner},
      {"this is right for a pull straight down; this one pulls to the side, too",
       right + 0.5 * with.time * Vec{with.a.x, 0, with.a.z}},
      {"this is minus the right velocity", -right}};
  for (const Mistake& mistake : known) {
    if (length(got - mistake.velocity) <= tolerance) return {mistake.says};
  }
  const double off = length(got - right) / length(right);
  if (off > 0 && off < 2e-6) return {"right to seven digits and no further: a float?"};
  return {};
}

grade::Curve flight(const std::string& name, const Throw& with, const Vec& v) {
  grade::Curve curve{name, {}, {}};
  for (int n = 0; n <= 40; ++n) {
    const Vec at = with.place(v, with.time * n / 40);
    curve.x.push_back(at.x);
    curve.y.push_back(at.y);
  }
  return curve;
}

void meets(Student& student, const Throw& with, const std::string& hint) {
  const Vec got = ask(student, with), expected = with.velocity();
  const Tolerance tolerance = rounding(with.size());
  grade::Finding finding = off_by(length(got - expected), tolerance);
  finding.asked = "the velocity with which a ball meets the runner";
  finding.input = "from " + describe(with.from, 17) + ", target " + describe(with.target, 17) +
                  ", runner " + describe(with.runner, 17) + ", a = " + describe(with.a, 17) +
                  ", time " + number(with.time, 17);
  finding.expected = describe(expected, 12);
  finding.got = describe(got, 12);
  finding.error += " m/s; the ball is " + number(with.miss(got), 3) +
                   " m away from the runner when the time is over";
  if (!finding.held) {
    finding.hint = hint;
    finding.diagnoses = recognise(got, with, tolerance.value);
    finding.plot = {"The throw, from the side",
                    "x [m]",
                    "y [m]",
                    {flight("yours", with, got), flight("the one that meets", with, expected)},
                    true};
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
  for (int n = 0; n < 3; ++n) {
    Throw with = draw(random);
    with.runner = random.vector(-6, 6);
    with.a = with.a + random.vector(-4, 4);
    meets(student, with, "The acceleration has three components, and each moves the ball.");
  }
}
