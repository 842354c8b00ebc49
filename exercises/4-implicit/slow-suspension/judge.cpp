// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

#include "format_values.h"
#include "judge/describe.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "scene.h"

using namespace judge;
using namespace judge::slow_suspension;

namespace {

using grade::number;

std::string text(const Swing& s) {
  return named("x", s.x, "v", s.v);
}

// The number of times that it passes through rest.
int passes(const std::vector<Swing>& path) {
  int count = 0;
  for (std::size_t n = 1; n < path.size(); ++n) count += (path[n].x < 0) != (path[n - 1].x < 0);
  return count;
}

// The angle by which a step of the trapezoid rule turns a spring.
double turned_by(double omega, double h) {
  const Swing next = Suspension{{1, 0}, h, omega, 0, 1}.after_one({1, 0});
  return std::atan2(-next.v / omega, next.x);
}

void check_steps(Student& student, const Suspension& scene, const Tolerance& tolerance,
                 const std::string& hint) {
  const auto expected = scene.right(), got = scene.by(student);
  std::size_t n = 1;
  while (n + 1 < got.size() && scene.apart(got[n], expected[n]) <= tolerance.value) ++n;

  grade::Finding finding = off_by(scene.apart(got[n], expected[n]), tolerance, " m");
  finding.asked = std::to_string(scene.steps) + " steps of the trapezoid rule";
  finding.input = scene.described();
  finding.expected = "after step " + std::to_string(n) + ": " + text(expected[n]);
  finding.got = "after step " + std::to_string(n) + ": " + text(got[n]);
  finding.error += ", with v over omega";
  if (!finding.held) {
    finding.hint = hint;
    finding.plot = scene.plot(got);
  }
  check(finding);
}

}  // namespace

TEST_CASE("each step takes the mean of both slopes", "[4-implicit/slow-suspension][2 points]") {
  Student student;
  Random random;
  for (int trial = 0; trial < 3; ++trial) {
    const double zeta = random.between(0.1, 0.5), angle = random.between(0.4, 3);
    const Suspension scene = Suspension::draw(random, angle, zeta, 20);
    check_steps(student, scene, rounding(scene.steps, scene.largest()),
                "Write down both lines for a spring, and collect what stands before the new "
                "velocity: one term from the velocity, one from the place.");
  }
}

TEST_CASE("without a damper the energy stays for a minute",
          "[4-implicit/slow-suspension][2 points]") {
  Student student;
  Random random;
  const Suspension scene = Suspension::a_minute(random);
  const auto got = scene.by(student);
  const int expected = passes(scene.right());
  const double size = scene.size(scene.start);
  double off = 0;
  for (const Swing& s : got) {
    const double now = std::abs(scene.size(s) - size);
    off = std::isfinite(now) ? std::max(off, now) : INFINITY;
  }
  const Tolerance tolerance = rounding(scene.steps, size);
  // A spring that stands still keeps its energy, too.
  const bool swings = 2 * passes(got) > expected;

  grade::Finding finding;
  finding.held = swings && off <= tolerance.value;
  finding.asked = "a minute without damping";
  finding.input = scene.described();
  finding.expected = "a swing of " + number(size) + " m, in each step";
  finding.got = "a swing that is off by up to " + number(off, 4) + " m";
  finding.error = swings ? number(off, 3) + " m" : "it hardly swings";
  finding.tolerance = number(tolerance.value, 2) + " m";
  finding.tolerance_from = tolerance.from;
  if (!finding.held) {
    finding.hint =
        "Multiply the line for the velocity by the mean of both velocities, and put in "
        "the line for the place: the energy must cancel. Which factor stops it?";
    finding.plot = {"The swing", "time [s]", "swing [m]", {scene.sizes("yours", got)}};
  }
  check(finding);
}

TEST_CASE("in a minute the suspension swings as often as the trapezoid rule lets it",
          "[4-implicit/slow-suspension][2 points]") {
  Student student;
  Random random;
  const Suspension scene = Suspension::a_minute(random);
  const auto got = scene.by(student);
  const double turn = 2 * std::atan(scene.h * scene.omega / 2);
  const double expected = scene.steps * turn / std::numbers::pi;
  const double counted = passes(got), off = std::abs(counted - expected);

  grade::Finding finding;
  finding.held = off <= 1;
  finding.asked = "how often it passes the place of rest in a minute, without damping";
  finding.input = scene.described();
  finding.expected = number(expected) + " times";
  finding.got = number(counted) + " times";
  finding.error = number(off, 3);
  finding.tolerance = "1";
  finding.tolerance_from =
      "a step of the trapezoid rule turns an undamped spring by 2 atan(h "
      "omega/2), half a turn is one passage, and both ends may cut one";
  if (!finding.held) {
    finding.hint =
        "The divisor acts like a mass: too large, and the swing is slow; too small, and it is "
        "fast.";
    finding.plot = scene.plot(got);
  }
  check(finding);
}

TEST_CASE("told another omega, the trapezoid rule swings at the one that is wanted",
          "[4-implicit/slow-suspension][3 points]") {
  Student student;
  Random random;
  // An angle, and a step or a rate that makes it. A small angle comes last: there the wrong ways
  // are hardly told apart.
  struct Told {
    double omega, h;
  };
  std::vector<Told> all;
  for (const double angle : {random.between(0.3, 0.6), random.between(1, 2.9), 3.1}) {
    const double h = random.between(0.01, 0.04);
    all.push_back({angle / h, h});
  }
  constexpr int more = 200;
  const double largest = 3.1;  // pi itself has no tangent
  for (int n = 0; n < more; ++n) {
    const double h = random.anywhere(harness_bounds::told_h);
    all.push_back({std::min(random.anywhere(harness_bounds::omega), largest / h), h});
  }
  for (const auto& [omega, h] : all) {
    const double wanted = omega * h;
    const double told = student.call(1, {omega, h}, 1)[0], turned = turned_by(told, h);
    const Tolerance tolerance = rounding(wanted);
    grade::Finding finding = off_by(std::abs(turned - wanted), tolerance);
    finding.asked = "by which angle a step of the trapezoid rule turns a spring that is told yours";
    finding.input = named("omega", omega, "h", h);
    finding.expected = number(wanted, 12) + ", which is omega h";
    finding.got = number(turned, 12) + ", told " + number(told, 12) + " rad/s";
    if (!finding.held) {
      finding.hint =
          "Half the angle is what the rule makes of half of h omega, and not the other way round.";
    }
    check(finding);
  }
}

TEST_CASE("any spring takes its step, forward or back, long or short, wherever it is",
          "[4-implicit/slow-suspension][1 point]") {
  Student student;
  Random random;
  constexpr int scenes = 300;
  for (int n = 0; n < scenes; ++n) {
    const Suspension scene = Suspension::anywhere(random);
    // Its step is as long, and what was kept of that does not fit another spring.
    Suspension next = scene;
    next.omega = random.anywhere(harness_bounds::omega);
    for (const Suspension& asked : {scene, next.askable() ? next : scene})
      check_steps(student, asked, rounding(asked.summed()),
                  "Is the step, the spring, the damper, the place or the velocity so small, so "
                  "large or so much zero here that a line of yours does something of its own?");
  }
}
