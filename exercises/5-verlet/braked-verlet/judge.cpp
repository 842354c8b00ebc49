// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "../order.h"
#include "scene.h"

using namespace judge;
using namespace judge::verlet;
using namespace judge::verlet::braked_verlet;

namespace {

using grade::number;

// The largest error of the places in two seconds, at sixteen times.
double error_of(Student& student, const Start& start, const harness::Force& spring, int steps) {
  constexpr int times = 16;
  const double h = 2.0 / steps;
  const Path yours = student.run(start, h, steps, steps / times, spring);
  const Path exact = truth(start, h, steps, steps / times, spring);
  double largest = 0;
  for (std::size_t n = 1; n < exact.states.size(); ++n) {
    const double error = length(yours.states[n].x - exact.states[n].x);
    if (!std::isfinite(error)) return error;
    largest = std::max(largest, error);
  }
  return largest;
}

// The larger root of a damped spring's step, in size: what is left of the slower motion by it.
double root(double zeta, double h_omega) {
  const double half = zeta * h_omega, b = (2 - h_omega * h_omega) / (2 * (1 + half));
  const double c = (1 - half) / (1 + half), under = b * b - c;
  return under < 0 ? std::sqrt(c) : std::abs(b) + std::sqrt(under);
}

// A run that does not blow up may still have no brake.
void comes_to_rest(Student& student, double zeta, const std::string& hint) {
  constexpr double h_omega = 1.96, least = 1e-3;
  Random random;
  const double omega = random.between(3, 9);
  const Start start = random.start();
  const harness::Force spring{harness::Force::spring, {omega, zeta}};
  const int steps = static_cast<int>(std::ceil(-20 / std::log(root(zeta, h_omega))));
  const Path path = student.run(start, h_omega / omega, steps, steps, spring);
  const double left = length(path.states.back().x) / distance({start.x, start.v}, {});
  grade::Finding finding;
  finding.held = left <= least;
  finding.asked = std::to_string(steps) + " steps of 1.96/omega on " + describe(spring);
  finding.input = describe(start) + ", h = " + number(h_omega / omega, 17);
  finding.expected = "it has come to rest";
  finding.got = number(left, 3) + " of the start is left";
  finding.error = number(left, 3);
  finding.tolerance = number(least);
  finding.tolerance_from =
      "in so many steps the right method divides the start by exp(20), and a thousandth is far "
      "more";
  if (!finding.held) {
    finding.hint = hint;
  }
  check(finding);
}

void bears(Student& student, double zeta, const std::string& hint) {
  is_stable_until(student, zeta, 2, hint);
  comes_to_rest(student, zeta, "It neither blows up nor calms down. Where is the drag?");
}

}  // namespace

TEST_CASE("one step takes the drag at the velocity of now", "[5-verlet/braked-verlet][3 points]") {
  Student student;
  solves(student, Line::draw());
  Random random;
  constexpr int lines = 300;
  for (int n = 0; n < lines; ++n) solves(student, Line::anywhere(random));
}

TEST_CASE("on a damped spring half the step leaves a quarter of the error",
          "[5-verlet/braked-verlet][2 points]") {
  Random random;
  const harness::Force spring{harness::Force::spring,
                              {random.between(2, 3), random.between(0.3, 0.6)}};
  const Start start = random.start();
  Student student;
  Halvings runs{"two seconds in 64 to 512 steps on " + describe(spring),
                describe(start),
                {},
                {},
                "Order one: the drag sees a velocity of another moment.",
                "An error that stays: some force is counted twice, or not at all."};
  for (int count = 64; count <= 512; count *= 2) {
    runs.steps.push_back(2.0 / count);
    runs.errors.push_back(error_of(student, start, spring, count));
  }
  has_order_two(runs);
}

TEST_CASE("a light damper leaves the limit of the step at h omega = 2",
          "[5-verlet/braked-verlet][2 points]") {
  Student student;
  bears(student, 0.15,
        "With the drag of half a step ago the limit is 2 (sqrt(1 + zeta^2) - zeta), with that of "
        "half a "
        "step ahead it lies beyond two.");
}

TEST_CASE("a critical damper and a heavy one leave the limit at h omega = 2, too",
          "[5-verlet/braked-verlet][3 points]") {
  Student student;
  for (const double zeta : {1.0, 4.0}) {
    bears(student, zeta,
          "The half that is divided must balance the half that is not. Is the push "
          "divided, too?");
  }
}
