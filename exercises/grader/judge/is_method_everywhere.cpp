// SPDX-License-Identifier: MIT-0
#include <array>

#include "format_values.h"
#include "judge/describe.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"

namespace judge {
namespace {

using grade::number;

constexpr harness::Bounds start_time{"t", -10, 1000, 0}, place{"x", 0, 20}, velocity{"v", 0, 20};
constexpr int scenes = 300, bodies = 3, rounds = 2;

State after(const Path& path) {
  return path.states.back();
}

grade::Finding compare(const State& got, const State& expected, double size) {
  grade::Finding finding = off_by(distance(got, expected), rounding(1, 1 + size));
  finding.expected = describe(expected);
  finding.got = describe(got);
  return finding;
}

// The question for each step.
struct Asked {
  const Method& method;
  const std::string& hint;
  int function;
};

State takes_step(Student& student, const Asked& asked, const Start& start, double h,
                 const harness::Force& force) {
  const auto step = [&](Student& who) {
    return after(who.run(start, h, 1, 1, force, asked.function));
  };
  const State right = after(run(asked.method, start, h, 1, 1, force)), got = step(student);
  const double size = distance(right, State{}) + distance({start.x, start.v}, State{});
  grade::Finding finding = compare(got, right, size);
  finding.asked = "one step of " + asked.method.name + " among those of three bodies by turns, " +
                  describe(force);
  finding.input = describe(start) + ", h = " + number(h, 17);
  if (!finding.held) {
    finding.hint = asked.hint;
    Student fresh;
    if (compare(step(fresh), right, size).held)
      finding.diagnoses = {
          "in a program that has just begun this step is right: what is remembered?"};
  }
  check(finding);
  return right;
}

}  // namespace

void is_method_everywhere(Student& student, const Method& method, const std::string& hint,
                          int function, const harness::Bounds& steps, bool drag) {
  Random random;
  const Asked asked{method, hint, function};
  for (int scene = 0; scene < scenes; ++scene) {
    harness::Force force = random.any_force(), other = random.any_force();
    if (!drag) force.a[6] = other.a[6] = 0;
    Start start;
    start.t = random.anywhere(start_time);
    std::array<State, bodies> body;
    for (State& state : body)
      state = {random.vector_anywhere(place), random.vector_anywhere(velocity)};
    for (int round = 0; round < rounds; ++round) {
      const double h = random.anywhere(steps);
      for (State& state : body) {
        start.x = state.x;
        start.v = state.v;
        state = takes_step(student, asked, start, h, force);
      }
      // The last of them once more, under another force.
      if (scene % 10 == 0) takes_step(student, asked, start, h, other);
      start.t += h;
    }
  }
}

}  // namespace judge
