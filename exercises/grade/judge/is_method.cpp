// SPDX-License-Identifier: MIT-0
#include <algorithm>

#include "judge/case.h"
#include "judge/describe.h"
#include "judge/diagnose.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "words.h"

namespace judge {
namespace {

using grade::number;

constexpr int steps = case_steps;

grade::Curve curve(const std::string& name, const Path& path) {
  grade::Curve curve{name, {}, {}};
  for (std::size_t n = 0; n < path.states.size(); ++n) {
    curve.x.push_back(path.time(n));
    curve.y.push_back(path.states[n].x.x);
  }
  return curve;
}

// The first step after which the two are further apart than rounding allows.
std::size_t first_wrong(const Path& yours, const Path& expected, double tolerance) {
  for (std::size_t n = 1; n < expected.states.size(); ++n) {
    if (!(distance(yours.states[n], expected.states[n]) <= tolerance)) return n;
  }
  return 0;
}

grade::Finding compare(const Path& yours, const Path& expected, const Case& with,
                       const std::string& name) {
  const Tolerance tolerance = rounding(steps, 1 + distance(expected.states.back(), State{}));
  const std::size_t n = first_wrong(yours, expected, tolerance.value);
  grade::Finding finding;
  finding.held = n == 0;
  finding.asked =
      std::to_string(steps) + " steps of " + name + " under a force that only the judge knows";
  finding.input = describe(with.start) + ", h = " + number(with.h, 17);
  finding.tolerance = number(tolerance.value, 2);
  finding.tolerance_from = tolerance.from;
  if (finding.held) return finding;
  finding.expected = "after step " + std::to_string(n) + ": " + describe(expected.states[n]);
  finding.got = "after step " + std::to_string(n) + ": " + describe(yours.states[n]);
  finding.error = number(distance(yours.states[n], expected.states[n]), 3);
  finding.plot = {"Five steps",
                  "time [s]",
                  "place along x [m]",
                  {curve("yours", yours), curve(name, expected)}};
  return finding;
}

void check_once(Student& student, const Method& method, const Case& with, const std::string& hint,
                int function, const std::string& after) {
  const Path yours = student.watch(with.start, with.h, steps, with.force, function);
  const auto by = [&](const Method& other) {
    return watch(other, with.start, with.h, steps, with.force);
  };
  grade::Finding finding = compare(yours, by(method), with, method.name);
  finding.asked += after;
  if (!finding.held) {
    finding.hint = hint;
    finding.diagnoses = diagnose(yours, by(method), by);
    if (!after.empty()) {
      finding.diagnoses.insert(finding.diagnoses.begin(),
                               "the first run was right: something is remembered from it");
    }
  }
  check(finding);
}

}  // namespace

void is_method(Student& student, const Method& method, const std::string& hint, int function) {
  Random random;
  const Case first = draw(random), second = draw(random);
  check_once(student, method, first, hint, function, "");
  check_once(student, method, second, hint, function, ", in a second run of the same program");
}

}  // namespace judge
