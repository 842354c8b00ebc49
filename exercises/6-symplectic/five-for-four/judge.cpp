// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "format_values.h"
#include "harness.h"
#include "judge/describe.h"
#include "judge/diagnose.h"
#include "judge/orbit_energy.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "judge/waves.h"
#include "scene.h"

using namespace judge;
using grade::number;

namespace {

double largest_error(const Path& path, const Path& exact) {
  double largest = 0;
  for (std::size_t n = 1; n < exact.states.size(); ++n) {
    const double error = distance(path.states[n], exact.states[n]);
    largest = std::isfinite(error) ? std::max(largest, error) : INFINITY;
  }
  return largest;
}

grade::Curve curve(const std::string& name, const Path& path) {
  grade::Curve curve{name, {}, {}};
  for (const State& state : path.states) {
    curve.x.push_back(state.x.x);
    curve.y.push_back(state.x.y);
  }
  return curve;
}

void takes_three(Student& student, Random& random, double h) {
  constexpr int steps = 3;
  const Start start = random.start();
  const harness::Force force = suzuki::draw_force(random);
  const auto by = [&](const Method& method) { return watch(method, start, h, steps, force); };
  const Path yours = student.watch(start, h, steps, force), expected = by(suzuki::asked);
  const double apart = largest_error(yours, expected);
  const Tolerance tolerance = rounding(steps, 1 + distance(expected.states.back(), State{}));

  grade::Finding finding;
  const std::size_t asked = yours.evaluations.size(), right = expected.evaluations.size();
  finding.held = apart <= tolerance.value && asked == right;
  finding.asked = "three steps in a force of place and time that only the judge knows";
  finding.input = describe(start) + ", h = " + number(h, 17);
  finding.expected = describe(expected.states[1]) + " after the first step, and " +
                     std::to_string(right) + " evaluations in all, one of them to begin with";
  finding.got = describe(yours.states[1]) + ", and " + std::to_string(asked);
  finding.error = number(apart, 3) + " in three steps";
  finding.tolerance = number(tolerance.value, 2) + ", and none in the count";
  finding.tolerance_from = tolerance.from;
  if (!finding.held) {
    finding.hint =
        "Do the lengths of your parts add up to h, and their cubes to nothing? Is each part "
        "told the time at which it starts?";
    finding.diagnoses = diagnose(yours, suzuki::asked, by);
  }
  check(finding);
}

}  // namespace

TEST_CASE("three steps are two parts forward, one back and two forward, at five evaluations each",
          "[6-symplectic/five-for-four][3 points]") {
  Student student;
  Random random;
  takes_three(student, random, random.between(0.3, 0.5));
  for (const double h : harness_bounds::h.asked()) takes_three(student, random, h);
}

TEST_CASE("a step of any length is right, forward and back, from wherever it starts",
          "[6-symplectic/five-for-four][1 point]") {
  Student student;
  is_method_everywhere(student, suzuki::asked,
                       "The same five parts make every step, however short, and a step back, too.",
                       0, harness_bounds::h, false);
}

TEST_CASE("half the step leaves a sixteenth of the error",
          "[6-symplectic/five-for-four][2 points]") {
  Student student;
  Random random;
  const Start start = random.start();
  const harness::Force force = suzuki::draw_force(random);
  constexpr int fewest = 8;
  const Path exact = truth(start, 1.0 / fewest, fewest, 1, force);
  std::vector<double> h, errors, slope;
  for (const int parts : {1, 2, 4}) {
    h.push_back(1.0 / (fewest * parts));
    errors.push_back(
        largest_error(student.run(start, h.back(), fewest * parts, parts, force), exact));
    slope.push_back(errors.front() * std::pow(h.back() * fewest, 4));
  }
  const double first = std::log2(errors[0] / errors[1]), second = std::log2(errors[1] / errors[2]);
  grade::Finding finding;
  finding.held = std::abs(second - 4) <= 0.1 && std::abs(second - first) <= 0.2;
  finding.asked = "one second in 8, 16 and 32 steps, in a force of place and time";
  finding.input = describe(start);
  finding.expected = "half the step divides the error by 16";
  finding.got = "errors " + number(errors[0], 3) + " " + number(errors[1], 3) + " " +
                number(errors[2], 3) + ", so orders " + number(first, 3) + " and " +
                number(second, 3);
  finding.error = number(second - 4, 3) + " of the order";
  finding.tolerance = "0.1, and the two orders within 0.2";
  finding.tolerance_from = "what terms of order six add at these steps";
  if (!finding.held) {
    finding.hint =
        "Order two is left if the cubes of the lengths do not add up to nothing, and order "
        "three if the parts do not read the same from both ends.";
    finding.plot = {"Error and step",
                    "step [s]",
                    "largest error [m]",
                    {{"yours", h, errors}, {"order 4", h, slope}},
                    false,
                    true};
  }
  check(finding);
}

TEST_CASE("twenty steps there and twenty back lead home",
          "[6-symplectic/five-for-four][2 points]") {
  Student student;
  runs_backwards(student, "The parts must read the same from both ends, and their times too.");
}

TEST_CASE("at the same price the probe lands four times nearer than Yoshida's",
          "[6-symplectic/five-for-four][2 points]") {
  Student student;
  Random random;
  const Orbit orbit = Orbit::draw(random, random.between(0.2, 0.4));
  constexpr int five = 180, three = 300;
  constexpr std::size_t price = 5 * five;
  const double seconds = random.between(2.3, 2.7) * orbit.period();
  const harness::Force sun = orbit.force();
  const Waves moons{random, 0.01 * orbit.mu, 2, orbit.period()};
  const Acceleration force = [=](const Vec& x, const Vec& v, double t) {
    return sun(x, v, t) + moons(x, t);
  };
  const Vec right = truth(orbit.start, seconds, 1, 1, force).states.back().x;
  const auto end_error = [&](const Path& path) { return length(path.states.back().x - right); };
  const Path yours = student.watch(orbit.start, seconds / five, five, force);
  const std::size_t count = yours.evaluations.size();
  const double best = end_error(run(suzuki::asked, orbit.start, seconds / five, five, 1, force));
  const double theirs = end_error(run(yoshida4, orbit.start, seconds / three, three, 1, force));

  grade::Finding finding;
  finding.held = end_error(yours) <= theirs / 4 && count <= price + 1;
  finding.asked = "two turns and a half of " + describe(sun) +
                  ", among moons that only the judge knows, for " + std::to_string(price) +
                  " evaluations: " + std::to_string(five) + " steps of yours, " +
                  std::to_string(three) + " of Yoshida's";
  finding.input = describe(orbit.start) + ", h = " + number(seconds / five, 17);
  finding.expected = "at most a quarter of what Yoshida's method is off, " + number(theirs, 3) +
                     " m, with " + std::to_string(price + 1) + " evaluations";
  finding.got =
      number(end_error(yours), 3) + " m off, with " + std::to_string(count) + " evaluations";
  finding.error = "a share of " + number(end_error(yours) / theirs, 3);
  finding.tolerance = "a share of 0.25";
  finding.tolerance_from =
      "Yoshida's method, run beside yours; the right lengths have a share of " +
      number(best / theirs, 2) + " here";
  if (!finding.held) {
    finding.hint =
        "The shorter the longest part, the less "
        "it errs.";
    if (count < price)
      finding.diagnoses = {"it asked " + std::to_string(count) +
                           " times: what stands in for the other answers knows nothing of the "
                           "moons"};
    finding.plot = {"Two turns and a half", "x [m]", "y [m]", {curve("yours", yours)}, true};
  }
  check(finding);
}
