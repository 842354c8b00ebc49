// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "format_values.h"
#include "harness.h"
#include "judge/describe.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"

using namespace judge;
using grade::number;

namespace {

void look(Student& student, double alpha) {
  student.call(0, {alpha}, 0);
}

std::string of_a_step(double alpha) {
  return number(alpha, 17) + " of a step ahead";
}

// Asks where a step with this share asks; where it ends does not matter.
Method looks_ahead(double alpha) {
  return method("a step that looks " + of_a_step(alpha),
                [alpha](Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
                  const double there = alpha * h;
                  const Vec pushed = v + there * acceleration(x, v, t);
                  acceleration(x + there * v, pushed, t + there);
                });
}

// Slopes that are summed up with weights of their own.
Method with_share(double share) {
  return method("the step that looks " + of_a_step(share),
                [share](Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
                  const Vec a = acceleration(x, v, t), v_ahead = v + share * h * a;
                  const Vec a_ahead = acceleration(x + share * h * v, v_ahead, t + share * h);
                  const double second = 1 / (2 * share);
                  x += h * ((1 - second) * v + second * v_ahead);
                  v += h * ((1 - second) * a + second * a_ahead);
                });
}

// A share of any size, one in three of them near to one that is special.
double any_share(Random& random) {
  const double drawn = random.anywhere(harness_bounds::alpha);
  if (random.whole(0, 2) > 0) return drawn;
  const double away = random.octaves(1e-5, 0.1);
  const double near[] = {0.5 - away, 0.5 + away, 1 - away};
  return near[random.whole(0, 2)];
}

// A fall without drag: each component is a parabola in time, which order two follows exactly.
void falls(Student& student, double alpha, Random& random) {
  const Start start = random.start();
  const double g = random.between(5, 15), h = random.between(0.05, 0.1);
  constexpr int steps = 20;
  const harness::Force pull{harness::Force::falling, {g, 0, 0}};
  const double got = student.run(start, h, steps, steps, pull, 1).states.back().x.y;
  const double t = steps * h, none = start.x.y + t * start.v.y, right = none - g * t * t / 2;
  const Tolerance tolerance = rounding(steps, 1 + std::abs(right) + g * t * t);
  grade::Finding finding = off_by(std::abs(got - right), tolerance, " m");
  finding.asked = "how high it is after " + std::to_string(steps) +
                  " steps under gravity alone, looking " + of_a_step(alpha);
  finding.input = describe(start) + ", h = " + number(h, 17) + ", g = " + number(g, 17) + " m/s^2";
  finding.expected = number(right, 12) + " m";
  finding.got = number(got, 12) + " m";
  if (!finding.held) {
    finding.hint = "Under a constant acceleration, which weights move x by h v + h^2 a / 2?";
    // Euler's places lag behind by half a push for each step.
    if (std::abs(got - (right + g * t * h / 2)) <= tolerance.value)
      finding.diagnoses = {"it falls as if x moved with the velocity of the start alone"};
  }
  check(finding);
}

// Takes one step with each of two shares by turns, all of the same length, of one body.
void takes_turns(Student& student, Random& random) {
  const double shares[] = {any_share(random), any_share(random)};
  const Start start = random.start();
  const double h = random.octaves(1e-4, 0.25);
  const harness::Force force = random.wild();
  for (const double alpha : {shares[0], shares[1], shares[0]}) {
    const auto step = [&](Student& who) {
      look(who, alpha);
      return who.run(start, h, 1, 1, force, 1).states.back();
    };
    const State got = step(student);
    const State right = run(with_share(alpha), start, h, 1, 1, force).states.back();
    const Tolerance tolerance = rounding(1, 1 + distance(right, State{}));
    grade::Finding finding = off_by(distance(got, right), tolerance);
    finding.asked = "a step that looks " + of_a_step(alpha) + ", by turns with one that looks " +
                    of_a_step(alpha == shares[0] ? shares[1] : shares[0]) + ", " + describe(force);
    finding.input = describe(start) + ", h = " + number(h, 17);
    finding.expected = describe(right);
    finding.got = describe(got);
    if (!finding.held) {
      finding.hint = "Every share has weights of its own, however near it is to another.";
      Student fresh;
      if (distance(step(fresh), right) <= tolerance.value)
        finding.diagnoses = {
            "in a program that has just begun this step is right: what is remembered?"};
    }
    check(finding);
  }
}

void order_two(Student& student, double alpha) {
  look(student, alpha);
  has_order(
      student, 2, 512,
      "Looking " + of_a_step(alpha) +
          ". Order one: the second slope has another weight than its share needs, or is asked "
          "for at another time.",
      1);
}

}  // namespace

TEST_CASE("a look half a step ahead makes the midpoint method, one a whole step ahead Heun's",
          "[3-runge-kutta/midpoint-line][2 points]") {
  Student student;
  look(student, 0.5);
  is_method(student, midpoint, "With one half, the second slope alone counts.", 1);
  look(student, 1);
  is_method(student, heun, "With a whole step, both slopes count the same.", 1);
}

TEST_CASE("a step looks twice, at the start and a share of the step ahead",
          "[3-runge-kutta/midpoint-line][2 points]") {
  Student student;
  Random random;
  const double alpha = random.between(0.6, 0.9);
  look(student, alpha);
  evaluates(student, looks_ahead(alpha), 2, 0,
            "The two formulas of the task say where, and the second look has a time of its own.",
            1);
}

TEST_CASE("half the step divides the error by four, whatever the share",
          "[3-runge-kutta/midpoint-line][3 points]") {
  Student student;
  Random random;
  order_two(student, random.between(0.25, 0.4));
  order_two(student, random.between(0.6, 0.9));
}

TEST_CASE("each share has its step, from anywhere, however long it is",
          "[3-runge-kutta/midpoint-line][1 point]") {
  Student student;
  Random random;
  constexpr int pairs = 150, shares = 4;
  for (int n = 0; n < pairs; ++n) takes_turns(student, random);
  for (int n = 0; n < shares; ++n) {
    const double alpha = any_share(random);
    look(student, alpha);
    is_method_everywhere(student, with_share(alpha),
                         "Every share has weights of its own, however near it is to another. Which "
                         "share or which step is so small or so large here that a line of yours "
                         "does something else?",
                         1);
  }
}

TEST_CASE("a thing that only falls falls as far as it should",
          "[3-runge-kutta/midpoint-line][2 points]") {
  Student student;
  Random random;
  std::vector<double> alphas{random.between(0.6, 0.9)};
  for (const double alpha : harness_bounds::alpha.asked()) alphas.push_back(alpha);
  for (const double alpha : alphas) {
    look(student, alpha);
    falls(student, alpha, random);
  }
}
