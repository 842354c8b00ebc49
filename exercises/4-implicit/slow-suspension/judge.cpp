// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <utility>

#include "format_values.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"

using namespace judge;

namespace {

using grade::number;

struct Swing {
  double x = 0, v = 0;
};

struct Suspension {
  Swing start;
  double h = 0, omega = 0, zeta = 0;
  int steps = 0;

  static Suspension draw(Random& random, double angle, double zeta, int steps) {
    const double h = random.between(0.01, 0.04), omega = angle / h;
    const double sign = 2.0 * random.whole(0, 1) - 1;
    return {
        {random.between(0.1, 0.3), sign * omega * random.between(0.1, 0.3)}, h, omega, zeta, steps};
  }

  // Long enough for a swing that is slower by a hundredth to fall behind.
  static Suspension a_minute(Random& random) {
    Suspension scene = draw(random, random.between(0.4, 1.2), 0, 0);
    scene.steps = static_cast<int>(60 / scene.h);
    return scene;
  }

  std::vector<Swing> by(Student& student) const {
    const auto n = student.call(0, {start.x, start.v, h, omega, zeta, double(steps)},
                                static_cast<std::size_t>(2 * steps));
    std::vector<Swing> path{start};
    for (std::size_t i = 0; i < n.size(); i += 2) path.push_back({n[i], n[i + 1]});
    return path;
  }

  // From (1 - h/2 A) end = (1 + h/2 A) start, by Cramer's rule.
  Swing after_one(const Swing& s) const {
    const double half = h / 2, k = omega * omega, c = 2 * zeta * omega;
    const double top = s.x + half * s.v, bottom = s.v + half * (-k * s.x - c * s.v);
    const double determinant = 1 + half * c + half * half * k;
    return {((1 + half * c) * top + half * bottom) / determinant,
            (bottom - half * k * top) / determinant};
  }

  std::vector<Swing> right() const {
    std::vector<Swing> path{start};
    for (int n = 0; n < steps; ++n) path.push_back(after_one(path.back()));
    return path;
  }

  // In units of length, in which the energy is a sum of two squares.
  double size(const Swing& s) const { return std::hypot(s.x, s.v / omega); }
  double apart(const Swing& a, const Swing& b) const { return size({a.x - b.x, a.v - b.v}); }

  std::string described() const {
    return "x = " + number(start.x, 17) + ", v = " + number(start.v, 17) +
           ", h = " + number(h, 17) + ", omega = " + number(omega, 17) +
           ", zeta = " + number(zeta, 17);
  }

  grade::Curve sizes(const std::string& name, const std::vector<Swing>& path) const {
    grade::Curve found = curve(name, path);
    for (std::size_t n = 0; n < found.y.size(); ++n) found.y[n] = size(path[n]);
    return found;
  }

  grade::Curve curve(const std::string& name, const std::vector<Swing>& path) const {
    grade::Curve curve{name, {}, {}};
    for (std::size_t n = 0; n < std::min<std::size_t>(path.size(), 60); ++n) {
      curve.x.push_back(static_cast<double>(n) * h);
      curve.y.push_back(path[n].x);
    }
    return curve;
  }

  grade::Plot plot(const std::vector<Swing>& yours) const {
    return {"The suspension",
            "time [s]",
            "stretch [m]",
            {curve("yours", yours), curve("the trapezoid rule", right())}};
  }
};

std::string text(const Swing& s) {
  return "x = " + number(s.x) + ", v = " + number(s.v);
}

// What a wrong first step often is: the trapezoid rule's change of velocity over another divisor,
// or another move.
std::vector<std::string> recognised(const Suspension& scene, const Swing& got, double within) {
  const auto [x, v] = scene.start;
  const double h = scene.h, half = h / 2;
  const double k = scene.omega * scene.omega, c = 2 * scene.zeta * scene.omega;
  const double push = half * (-k * (2 * x + h * v) - 2 * c * v);
  const auto divided = [&](double by) {
    return Swing{x + h * v + half * push / by, v + push / by};
  };
  const double v_right = scene.after_one(scene.start).v;
  const double v_backward = (v - h * k * x) / (1 + h * c + h * h * k);
  const std::pair<Swing, const char*> known[] = {
      {divided(1 + half * c + half * h * k), "this is the step of the code as it was"},
      {divided(1), "this is the step of Heun's method: nothing is divided"},
      {divided(1 + h * c + half * half * k), "the damping in the divisor is not halved"},
      {{x + h * v_backward, v_backward}, "this is backward Euler"},
      {{x + h * v_right, v_right}, "the velocity is right; the place moved with the new one alone"},
  };
  for (const auto& [end, says] : known) {
    if (scene.apart(got, end) <= within) return {says};
  }
  return {};
}

// How often it passes through rest.
int passes(const std::vector<Swing>& path) {
  int count = 0;
  for (std::size_t n = 1; n < path.size(); ++n) count += (path[n].x < 0) != (path[n - 1].x < 0);
  return count;
}

}  // namespace

TEST_CASE("each step takes the mean of both slopes", "[4-implicit/slow-suspension][4 points]") {
  Student student;
  Random random;
  for (int trial = 0; trial < 3; ++trial) {
    const Suspension scene =
        Suspension::draw(random, random.between(0.4, 3), random.between(0.1, 0.5), 20);
    const auto expected = scene.right(), got = scene.by(student);
    const Tolerance tolerance = rounding(scene.steps, scene.size(scene.start));
    std::size_t n = 1;
    while (n + 1 < got.size() && scene.apart(got[n], expected[n]) <= tolerance.value) ++n;

    grade::Finding finding = off_by(scene.apart(got[n], expected[n]), tolerance, " m");
    finding.asked = std::to_string(scene.steps) + " steps of the trapezoid rule";
    finding.input = scene.described();
    finding.expected = "after step " + std::to_string(n) + ": " + text(expected[n]);
    finding.got = "after step " + std::to_string(n) + ": " + text(got[n]);
    finding.error += ", with v over omega";
    if (!finding.held) {
      finding.hint =
          "Write down both lines for a spring, and collect what stands before the new "
          "velocity: one term from the velocity, one from the place.";
      finding.plot = scene.plot(got);
      finding.diagnoses = recognised(scene, got[1], tolerance.value);
    }
    check(finding);
  }
}

TEST_CASE("without a damper its energy stays for a minute",
          "[4-implicit/slow-suspension][3 points]") {
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
  // What stands still keeps its energy, too.
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

TEST_CASE("in a minute it swings as often as the trapezoid rule lets it",
          "[4-implicit/slow-suspension][3 points]") {
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
