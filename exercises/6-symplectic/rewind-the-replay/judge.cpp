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
using grade::number;

namespace {

enum Function { step, undo };

// Steps that somebody else took, under a force that only the judge knows.
struct Replay {
  Start start;
  harness::Force force;
  double h;
  int steps;
  Path there;

  // @param step  its size; drawn, if it is 0
  explicit Replay(int count, double step = 0) : steps(count) {
    Random random;
    start = random.start();
    force = random.wild();
    force.a[6] = 0;  // no drag
    h = step > 0 ? step : random.between(0.05, 0.15);
    there = watch(symplectic_euler, start, h, steps, force);
  }

  Start end() const { return {there.states.back().x, there.states.back().v, start.t + steps * h}; }

  // Backwards by any method.
  Path by(const Method& method) const { return watch(method, end(), -h, steps, force); }

  grade::Finding asked() const {
    grade::Finding finding;
    finding.asked = std::to_string(steps) +
                    " steps of symplectic Euler to be undone, in a force of place and time that "
                    "only the judge knows, h = " +
                    number(h, 17);
    finding.input = "after the last step: " + describe(end());
    return finding;
  }
};

grade::Curve curve(const std::string& name, const Path& path) {
  grade::Curve curve{name, {}, {}};
  for (std::size_t n = 0; n < path.states.size(); ++n) {
    curve.x.push_back(path.time(n));
    curve.y.push_back(path.states[n].x.x);
  }
  return curve;
}

// The student's own steps over the time of a replay.
Path steps_of(Student& student, const Replay& replay) {
  return student.watch(replay.start, replay.h, replay.steps, replay.force);
}

// The diagnosis of a step, by the way that it took.
std::vector<std::string> what_it_is(const Replay& replay, const Path& yours) {
  return diagnose(yours, symplectic_euler, [&](const Method& method) {
    return watch(method, replay.start, replay.h, replay.steps, replay.force);
  });
}

// The diagnosis of an undo, by the way back that it took.
std::vector<std::string> recognised(const Replay& replay, const Path& yours) {
  if (yours.evaluations.empty() && distance(yours.states.back(), yours.states.front()) == 0)
    return {
        "undo asks for nothing and changes nothing: what your step has noted down is of no use "
        "here, where somebody else took the steps"};
  const auto by = [&](const Method& method) { return replay.by(method); };
  std::vector<std::string> found = diagnose(yours, symplectic_euler_position_first, by);
  for (std::string& remark : found) {
    if (remark.starts_with("this is ")) remark += ", run with -h";
  }
  return found;
}

// Returns whether an undo asked at the position and the time of the step that it takes back.
bool asked_alike(const Evaluation& yours, const Evaluation& step, double tolerance) {
  return length(yours.x - step.x) <= tolerance && std::abs(yours.t - step.t) <= tolerance;
}

void takes(Student& student, const Replay& replay) {
  const Path yours = steps_of(student, replay);
  const State &end = yours.states.back(), &right = replay.there.states.back();
  const double apart = distance(end, right);
  const Tolerance tolerance = rounding(replay.steps, 1 + distance(right, State{}));

  grade::Finding finding;
  finding.held =
      apart <= tolerance.value && yours.evaluations.size() == replay.there.evaluations.size();
  finding.asked =
      std::to_string(replay.steps) +
      " steps in a force of place and time that only the judge knows, h = " + number(replay.h, 17);
  finding.input = describe(replay.start);
  finding.expected = describe(right) + ", for one evaluation a step";
  finding.got = describe(end) + ", for " + std::to_string(yours.evaluations.size());
  finding.error = number(apart, 3);
  finding.tolerance = number(tolerance.value, 2);
  finding.tolerance_from = tolerance.from;
  if (!finding.held) {
    finding.hint = "Change the velocity first, and move with the new one.";
    finding.diagnoses = what_it_is(replay, yours);
  }
  check(finding);
}

void leads_back(Student& student, const Replay& replay) {
  const Path yours = student.watch(replay.end(), -replay.h, replay.steps, replay.force, undo);
  const State home{replay.start.x, replay.start.v};
  const Tolerance tolerance =
      rounding(2 * replay.steps, 1 + distance(replay.there.states.back(), State{}));
  const double apart = distance(yours.states.back(), home);

  grade::Finding finding = replay.asked();
  finding.held = apart <= tolerance.value;
  finding.expected = describe(home);
  finding.got = describe(yours.states.back());
  finding.error = number(apart, 3);
  finding.tolerance = number(tolerance.value, 2);
  finding.tolerance_from = tolerance.from;
  if (!finding.held) {
    finding.hint =
        "Take the drift back first: then the acceleration is asked for where the step "
        "asked for it.";
    finding.diagnoses = recognised(replay, yours);
    finding.plot = {"Backwards",
                    "time [s]",
                    "place along x [m]",
                    {curve("yours", yours), curve("the replay", replay.there)}};
  }
  check(finding);
}

}  // namespace

TEST_CASE("five steps under a hidden force are those of symplectic Euler",
          "[6-symplectic/rewind-the-replay][2 points]") {
  Student student;
  takes(student, Replay(5));
  for (const double h : harness_bounds::h.asked()) takes(student, Replay(5, h));
}

TEST_CASE("a spring swings on while h omega is less than two, and no longer",
          "[6-symplectic/rewind-the-replay][2 points]") {
  Student student;
  is_stable_until(student, 0, 2,
                  "Move with the velocity that the kick has made, not with the old one.");
}

TEST_CASE("undone steps lead back to the start of the replay",
          "[6-symplectic/rewind-the-replay][3 points]") {
  Student student;
  leads_back(student, Replay(20));
  for (const double h : harness_bounds::h.asked()) leads_back(student, Replay(5, h));
}

TEST_CASE("an undo asks once, at the place and time where its step asked",
          "[6-symplectic/rewind-the-replay][2 points]") {
  Student student;
  const Replay replay(3);
  const Path yours = student.watch(replay.end(), -replay.h, replay.steps, replay.force, undo);
  const double tolerance = rounding(replay.steps, 2).value;

  grade::Finding finding = replay.asked();
  finding.held = yours.evaluations.size() == replay.there.evaluations.size();
  finding.expected = std::to_string(replay.steps) + " evaluations";
  finding.got = std::to_string(yours.evaluations.size()) + " evaluations";
  finding.error = "one undo asks once";
  for (std::size_t n = 0; finding.held && n < yours.evaluations.size(); ++n) {
    const Evaluation& step = *(replay.there.evaluations.rbegin() + static_cast<long>(n));
    const Evaluation& undone = yours.evaluations[n];
    finding.held = asked_alike(undone, step, tolerance);
    finding.expected = "undo " + std::to_string(n + 1) + " asks at x = " + describe(step.x) +
                       ", t = " + number(step.t);
    finding.got = "at x = " + describe(undone.x) + ", t = " + number(undone.t);
    finding.error =
        number(length(undone.x - step.x), 3) + " m, " + number(undone.t - step.t, 3) + " s";
  }
  finding.tolerance = number(tolerance, 2) + " in place and time, none in the count";
  finding.tolerance_from = rounding(replay.steps, 2).from;
  if (!finding.held) {
    finding.hint = "Undo the drift, then ask, once, at the time that undo is given.";
    finding.diagnoses = asked_elsewhere(yours, replay.by(symplectic_euler_position_first));
  }
  check(finding);
}

TEST_CASE("any step is taken and taken back, from wherever it starts, however short",
          "[6-symplectic/rewind-the-replay][1 point]") {
  Student student;
  const std::string hint =
      "Two lines make every step, and two take it back, also of what is at rest or at the origin.";
  is_method_everywhere(student, symplectic_euler, hint, step, harness_bounds::h, false);
  constexpr harness::Bounds back{"h", -harness_bounds::h.largest(), -harness_bounds::h.smallest()};
  session().given = "; undo is called, and gets the size of the step that it takes back, above 0";
  is_method_everywhere(student, symplectic_euler_position_first, hint, undo, back, false);
}
