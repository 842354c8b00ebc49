// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "../order.h"
#include "../places.h"
#include "judge/random.h"

using namespace judge;
using namespace judge::verlet;

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
  if (!finding.held) finding.hint = hint;
  check(finding);
}

void bears(Student& student, double zeta, const std::string& hint) {
  is_stable_until(student, zeta, 2, hint);
  comes_to_rest(student, zeta, "It neither blows up nor calms down. Where is the drag?");
}

}  // namespace

TEST_CASE("one step takes the drag at the velocity of now", "[5-verlet/braked-verlet][3 points]") {
  Random random;
  const Vec x = random.start().x, before = random.start().x, a = random.vector(2, 9);
  const double h = random.between(0.1, 0.3), c = random.between(2, 12);
  Student student;
  const std::vector<Vec> yours = as_places(
      student.call(1, {x.x, x.y, x.z, before.x, before.y, before.z, a.x, a.y, a.z, c, h}, 3));
  const Vec d = x - before, push = h * h * a;
  const double half = c * h / 2, left = std::exp(-c * h);
  Asked asked{"next_place",
              "x = " + describe(x, 17) + ", x_previous = " + describe(before, 17) +
                  ", a = " + describe(a, 17) + ", c = " + number(c, 17) + ", h = " + number(h, 17),
              rounding(length(x) + length(before) + length(a)),
              "Put your result into the two formulas of the task. Do both sides agree?",
              {}};
  const Vec v = (yours[0] - before) / (2 * h), other_side = x + d + push - h * h * c * v;
  asked.remarks = {"with your place v is " + describe(v) +
                   ", and then the right side of the formula is " + describe(other_side)};
  are_places(asked, yours,
             {"drag at the velocity of now", {x + ((1 - half) * d + push) / (1 + half)}},
             {{"position Verlet with the drag of half a step ago, as in the chapter",
               {x + (1 - c * h) * d + push}},
              {"position Verlet without drag", {x + d + push}},
              {"drag at the velocity of half a step ahead: x_next - x over h",
               {x + (d + push) / (1 + c * h)}},
              {"a push that is not divided", {x + (1 - half) / (1 + half) * d + push}},
              {"only half of the drag, the half that is known", {x + (1 - half) * d + push}},
              {"only half of the drag, the half that is divided", {x + (d + push) / (1 + half)}},
              {"drag with the wrong sign: it drives", {x + ((1 + half) * d + push) / (1 - half)}},
              {"exp(-c h) on the distance alone: stable a little further, and of order one",
               {x + left * d + push}},
              {"exact drag under a constant force: a good method, and another than was asked for",
               {x + left * d + (1 - left) * h / c * a}},
              {"drag without the step: c for c h", {x + ((1 - c / 2) * d + push) / (1 + c / 2)}},
              {"everything divided, the place along with it",
               {(x + (1 - half) * d + push) / (1 + half)}}});
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

TEST_CASE("a critical damper and a heavy one leave it there, too",
          "[5-verlet/braked-verlet][3 points]") {
  Student student;
  for (const double zeta : {1.0, 4.0}) {
    bears(student, zeta,
          "The half that is divided must balance the half that is not. Is the push "
          "divided, too?");
  }
}
