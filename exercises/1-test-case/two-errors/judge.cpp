// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "format_values.h"
#include "harness.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "leaf.h"
#include "runs.h"

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
  const double got = student.call(evaluations, {duration, h, static_cast<double>(per_step)}, 1)[0];
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
  const double got = student.call(order, {two.h1, two.error1, two.h2, two.error2}, 1)[0];
  const double expected = two.order();
  grade::Finding finding =
      off_by(std::abs(got - expected), order_tolerance(expected, two.h1, two.h2));
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
    finding.diagnoses = recognise_order(got, two);
  }
  check(finding);
}

// With C h^p for the error, from a run: whether it is the wanted one with the student's step.
void allows(Student& student, double wanted, double h, double error, double p) {
  const double got = student.call(step_for, {wanted, h, error, p}, 1)[0];
  const Wanted ask{wanted, h, error, p};
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
    finding.diagnoses = recognise_step(got, ask);
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

struct Ends {
  double h, error;
};

// A short step with a small error, and a long one with a large error.
std::vector<Ends> ends(const harness::Bounds& h, const harness::Bounds& error) {
  return {{h.smallest(), error.smallest()}, {h.largest(), error.largest()}};
}

// Far enough from a whole number that rounding cannot choose.
bool between_whole_numbers(double number) {
  return std::abs(number - std::round(number)) > 1e-3;
}

}  // namespace

TEST_CASE("the order comes from two errors, whatever their steps",
          "[1-test-case/two-errors][3 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 6; ++n) {
    const double p = random.between(0.8, 4.3), size = random.between(0.5, 30);
    const double h1 = random.between(0.01, 0.1), h2 = h1 / random.between(2.2, 10);
    two_runs(student, {h1, size * std::pow(h1, p), h2, size * std::pow(h2, p)});
  }
  // The coarser of two runs at the ends of its bounds, and then the finer one.
  for (const auto& [h1, error1] : ends(harness_bounds::h1, harness_bounds::error1)) {
    const double ratio = random.between(9, 10), p = random.between(1.1, 3);
    two_runs(student, {h1, error1, h1 / ratio, error1 / std::pow(ratio, p)});
  }
  for (const auto& [h2, error2] : ends(harness_bounds::h2, harness_bounds::error2)) {
    const double ratio = error2 < 1 ? random.between(10, 100) : random.between(1.1, 2);
    const double p = error2 < 1 ? random.between(4, 4.3) : random.between(0.8, 3);
    two_runs(student, {ratio * h2, std::pow(ratio, p) * error2, h2, error2});
  }
}

TEST_CASE("the step is as long as the wanted error allows", "[1-test-case/two-errors][3 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 6; ++n) {
    const double p = random.between(2.1, 4.3), h = random.between(0.01, 0.1);
    const double error = random.between(0.001, 0.5), wanted = error * random.between(0.02, 0.5);
    allows(student, wanted, h, error, p);
  }
  for (const double p : random.all_of(harness_bounds::p, 1))
    for (const double wanted :
         {harness_bounds::wanted.smallest(), harness_bounds::wanted.largest()})
      for (const auto& [h, error] : ends(harness_bounds::h, harness_bounds::error))
        allows(student, wanted, h, error, p);
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
  const auto steps = [&](int low, int high) {
    const int whole = random.whole(low, high);
    return whole + random.between(0.1, 0.9);
  };
  const int some = random.whole(2, 7);
  for (const double duration : harness_bounds::duration.asked())
    counts(student, duration, duration / steps(700, 2000), some);
  for (const double per_step : harness_bounds::per_step.asked())
    counts(student, 1, 1 / steps(20, 200), static_cast<int>(per_step));
  const double shortest = harness_bounds::h.smallest(), longest = harness_bounds::h.largest();
  counts(student, steps(2000, 5000) * shortest, shortest, some);
  counts(student, random.between(0.2, 0.8) * longest, longest, some);
  // Steps that divide the run without rounding, and one that is all of it.
  counts(student, longest, longest, some);
  counts(student, random.whole(2, 9), 1.0 / (1 << random.whole(3, 7)), random.whole(2, 4));
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
