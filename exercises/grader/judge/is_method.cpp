// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <cmath>

#include "format_values.h"
#include "judge/case.h"
#include "judge/describe.h"
#include "judge/diagnose.h"
#include "judge/session.h"
#include "judge/tests.h"

namespace judge {
namespace {

using grade::number;

constexpr int steps = case_steps;

// One number of a state.
struct Component {
  const char* label;
  Vec State::* of;
  double Vec::* along;

  double in(const State& state) const { return state.*of.*along; }
};

constexpr Component components[] = {
    {"place along x [m]", &State::x, &Vec::x},      {"place along y [m]", &State::x, &Vec::y},
    {"place along z [m]", &State::x, &Vec::z},      {"velocity along x [m/s]", &State::v, &Vec::x},
    {"velocity along y [m/s]", &State::v, &Vec::y}, {"velocity along z [m/s]", &State::v, &Vec::z}};

// The one in which two states differ most.
const Component& most_different(const State& a, const State& b) {
  const auto apart = [&](const Component& of) { return std::abs(of.in(a)-of.in(b)); };
  return *std::ranges::max_element(components, {}, apart);
}

grade::Curve curve(const std::string& name, const Path& path, const Component& of) {
  grade::Curve curve{name, {}, {}};
  for (std::size_t n = 0; n < path.states.size(); ++n) {
    curve.x.push_back(path.time(n));
    curve.y.push_back(of.in(path.states[n]));
  }
  return curve;
}

std::string which_is_off(const State& yours, const State& expected, double tolerance) {
  if (length(yours.x - expected.x) <= tolerance) return ", in the velocity; the place is right";
  if (length(yours.v - expected.v) <= tolerance) return ", in the place; the velocity is right";
  return "";
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
  finding.error = number(distance(yours.states[n], expected.states[n]), 3) +
                  which_is_off(yours.states[n], expected.states[n], tolerance.value);
  const Component& most = most_different(yours.states.back(), expected.states.back());
  finding.plot = {"Five steps",
                  "time [s]",
                  most.label,
                  {curve("yours", yours, most), curve(name, expected, most)}};
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
    finding.diagnoses = diagnose(yours, method, by);
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
