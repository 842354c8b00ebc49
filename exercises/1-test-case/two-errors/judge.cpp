// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "format_values.h"
#include "harness.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "scene.h"

using namespace judge;
using namespace runs;

namespace {

std::string in_evaluations(double count) {
  return grade::number(count) + (count == 1 ? " evaluation" : " evaluations");
}

using grade::number;

enum Function { order, step_for, evaluations };

// Rounding in a quotient of logarithms: what enters is wrong by a rounding, and the logarithm of
// that is small if the two steps are near each other.
Tolerance order_tolerance(double p, double h1, double h2) {
  const Tolerance plain = rounding(p + 1);
  return {plain.value / std::min(1.0, std::abs(std::log(h1 / h2))), plain.from};
}

struct Choice {
  const Method& method;
  int per_step;
};

std::string evaluations_of(double count, int per_step) {
  return number(count, 12) + " evaluations, which is " + number(count / per_step, 12) + " steps";
}

void counts(Student& student, double duration, double h, int per_step) {
  const auto ask = [&](Student& who) {
    return who.call(evaluations, {duration, h, static_cast<double>(per_step)}, 1)[0];
  };
  const double got = ask(student);
  const double expected = std::ceil(duration / h) * per_step;
  grade::Finding finding;
  finding.held = got == expected;
  finding.asked = "the evaluations of a run in steps not longer than h";
  finding.input = "duration = " + number(duration, 17) + " s, h = " + number(h, 17) +
                  " s, per_step = " + std::to_string(per_step) + "; " + number(duration / h, 8) +
                  " such steps";
  finding.expected = evaluations_of(expected, per_step);
  finding.got = evaluations_of(got, per_step);
  finding.error = in_evaluations(std::abs(got - expected));
  finding.tolerance = "none";
  finding.tolerance_from = "evaluations are counted";
  if (!finding.held) {
    finding.hint = "Steps come whole. Which whole number is the first that is large enough?";
    if (std::fmod(got, per_step) != 0) finding.diagnoses = {"this is no whole number of steps"};
    if (got == expected - per_step) finding.diagnoses = {"one step too few"};
    if (got == expected + per_step) finding.diagnoses = {"one step too many"};
    if (got * per_step == expected) finding.diagnoses = {"this is the number of steps"};
  }
  check(finding);
}

void two_runs(Student& student, const Runs& two) {
  const auto ask = [&](Student& who) {
    return who.call(order, {two.h1, two.error1, two.h2, two.error2}, 1)[0];
  };
  const double got = ask(student), expected = two.order();
  const Tolerance tolerance = order_tolerance(expected, two.h1, two.h2);
  grade::Finding finding = off_by(std::abs(got - expected), tolerance);
  finding.asked = "the order that two runs show";
  finding.input = "h1 = " + number(two.h1, 17) + " s, error1 = " + number(two.error1, 17) +
                  " m, h2 = " + number(two.h2, 17) + " s, error2 = " + number(two.error2, 17) +
                  " m";
  finding.expected = number(expected, 12);
  finding.got = number(got, 12);
  if (!finding.held) {
    finding.hint =
        "On logarithmic scales an order is a slope: height over width, and the steps are not "
        "halved here.";
  }
  check(finding);
}

// Checks, with C h^p for the error, whether the student's step has the wanted one.
void allows(Student& student, const Wanted& ask) {
  const auto& [wanted, h, error, p] = ask;
  const auto step = [&](Student& who) {
    return who.call(step_for, {ask.wanted, ask.h, ask.error, ask.p}, 1)[0];
  };
  const double got = step(student);
  Tolerance tolerance = rounding(wanted);
  tolerance.value *= 1 + p;
  grade::Finding finding = off_by(std::abs(ask.error_with(got, p) - wanted), tolerance, " m");
  finding.asked = "the step for a wanted error";
  finding.input = "wanted = " + number(wanted, 17) + " m, h = " + number(h, 17) +
                  " s, error = " + number(error, 17) + " m, p = " + number(p, 17);
  finding.expected = "a step with an error of " + number(wanted, 12) + " m";
  finding.got =
      number(got, 12) + " s, with an error of " + number(ask.error_with(got, p), 12) + " m";
  if (!finding.held) {
    finding.hint =
        "The errors are in the ratio of the steps, to the power of p. Which way round do you need "
        "it?";
  }
  check(finding);
}

// The student's three functions one after the other, as in a real study.
double price(Student& student, double wanted, const Leaf& leaf, const Choice& with, double h1,
             double error1, double h2, double error2) {
  const double p = student.call(order, {h1, error1, h2, error2}, 1)[0];
  const double h = student.call(step_for, {wanted, h2, error2, p}, 1)[0];
  return student.call(evaluations, {leaf.duration, h, static_cast<double>(with.per_step)}, 1)[0];
}

// Far enough from a whole number that rounding cannot choose.
bool between_whole_numbers(double number) {
  return std::abs(number - std::round(number)) > 1e-3;
}

}  // namespace

TEST_CASE("the order comes from two errors, whatever their steps",
          "[1-test-case/two-errors][2 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 6; ++n) {
    const double p = random.between(0.8, 4.3), size = random.between(0.5, 30);
    const double h1 = random.between(0.01, 0.1), h2 = h1 / random.between(2.2, 10);
    two_runs(student, {h1, size * std::pow(h1, p), h2, size * std::pow(h2, p)});
  }
}

TEST_CASE("the step is as long as the wanted error allows", "[1-test-case/two-errors][3 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 6; ++n) {
    const double p = random.between(2.1, 4.3), h = random.between(0.01, 0.1);
    const double error = random.between(0.001, 0.5), wanted = error * random.between(0.02, 0.5);
    allows(student, {wanted, h, error, p});
  }
}

TEST_CASE("a run takes as few whole steps as it can", "[1-test-case/two-errors][2 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 6; ++n) {
    const int per_step = random.whole(2, 7), whole = random.whole(20, 2000);
    const double duration = random.between(1, 9);
    const double part = n % 2 == 0 ? random.between(0.1, 0.4) : random.between(0.6, 0.9);
    counts(student, duration, duration / (whole + part), per_step);
  }
  // Steps that divide the run without rounding, and one that is all of it.
  const double longest = harness_bounds::h.largest();
  counts(student, longest, longest, random.whole(2, 7));
  const int per_step = random.whole(2, 4), halvings = random.whole(3, 7);
  counts(student, random.whole(2, 9), 1.0 / (1 << halvings), per_step);
}

TEST_CASE("the price of an error is right for a leaf that fell",
          "[1-test-case/two-errors][2 points]") {
  Student student;
  Random random;
  for (const Choice& with : {Choice{euler, 1}, Choice{midpoint, 2}, Choice{rk4, 4}}) {
    const Leaf leaf = Leaf::draw(random);
    const int first = random.whole(100, 140), second = first * 2 + random.whole(9, 90);
    const double h1 = leaf.duration / first, h2 = leaf.duration / second;
    const double error1 = leaf.error(with.method, first), error2 = leaf.error(with.method, second);
    const double p = Runs{h1, error1, h2, error2}.order();
    double wanted, steps;
    do {
      wanted = error2 / random.between(3, 30);
      steps = leaf.duration / (h2 * std::pow(wanted / error2, 1 / p));
    } while (!between_whole_numbers(steps));
    const double expected = std::ceil(steps) * with.per_step;
    const double got = price(student, wanted, leaf, with, h1, error1, h2, error2);

    grade::Finding finding;
    finding.held = got == expected;
    finding.asked = "what it costs to keep a falling leaf within " + number(wanted) + " m with " +
                    with.method.name + ": order, step_for and evaluations one after the other";
    finding.input = number(h1, 17) + " s gave " + number(error1, 17) + " m, " + number(h2, 17) +
                    " s gave " + number(error2, 17) + " m; wanted " + number(wanted, 17) +
                    " m over " + number(leaf.duration) + " s, " + std::to_string(with.per_step) +
                    " evaluations a step";
    finding.expected = evaluations_of(expected, with.per_step) + "; run with these, the leaf is " +
                       number(leaf.error(with.method, static_cast<int>(std::ceil(steps))), 3) +
                       " m off";
    finding.got = evaluations_of(got, with.per_step);
    finding.error = in_evaluations(std::abs(got - expected));
    finding.tolerance = "none";
    finding.tolerance_from = "evaluations are counted";
    if (!finding.held) {
      finding.hint = "See first that the three functions are right one by one.";
      if (got * with.per_step == expected) finding.diagnoses = {"this is the number of steps"};
    }
    check(finding);
  }
}

TEST_CASE("order, step and count are right for any steps and errors, and for two scenes by turns",
          "[1-test-case/two-errors][1 point]") {
  Student student;
  Random random;
  constexpr int pairs = 160;
  for (int n = 0; n < pairs; ++n) {
    const double h1 = random.anywhere(harness_bounds::h1), h = random.anywhere(harness_bounds::h);
    const Runs runs[]{any_runs(random, h1), any_runs(random, h1)};
    const Wanted wanted[]{any_wanted(random, h), any_wanted(random, h)};
    const double duration[]{any_duration(random, h), any_duration(random, h)};
    const int per_step = static_cast<int>(random.anywhere(harness_bounds::per_step));
    for (int scene = 0; scene < 2; ++scene) {
      two_runs(student, runs[scene]);
      allows(student, wanted[scene]);
      counts(student, duration[scene], h, per_step);
    }
  }
}
