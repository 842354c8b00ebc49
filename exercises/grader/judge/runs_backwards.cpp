// SPDX-License-Identifier: MIT-0
#include <cmath>

#include "format_values.h"
#include "judge/describe.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"

namespace judge {
namespace {

using grade::number;

constexpr int steps_there = 20;

// Nearer to the truth than a straight line: what does nothing comes back, too.
bool moves(const Path& there, const Start& start, const harness::Force& force) {
  const Path exact = truth(start, there.h, steps_there, steps_there, force);
  const Vec straight = start.x + (steps_there * there.h) * start.v;
  return length(there.states.back().x - exact.states.back().x) <
         0.5 * length(straight - exact.states.back().x);
}

}  // namespace

void runs_backwards(Student& student, const std::string& hint, int function) {
  Random random;
  const Start start = random.start();
  harness::Force force = random.wild();
  force.a[6] = 0;  // no drag: what drag took, no method gives back
  const double h = random.between(0.03, 0.06);
  const Path there = student.run(start, h, steps_there, steps_there, force, function);
  const State end = there.states.back();
  const Start turned{end.x, end.v, start.t + steps_there * h};
  // In another program, which can have noted down nothing on the way there.
  Student fresh;
  const Path back = fresh.run(turned, -h, steps_there, steps_there, force, function);
  const State home{start.x, start.v};
  const Tolerance tolerance = rounding(2 * steps_there, 1 + distance(end, State{}));

  const bool moved = moves(there, start, force);
  grade::Finding finding = off_by(distance(back.states.back(), home), tolerance);
  finding.held = finding.held && moved;
  finding.asked =
      std::to_string(steps_there) + " steps forward and as many back with -h, " + describe(force);
  finding.input = describe(start) + ", h = " + number(h, 17);
  finding.expected = describe(home);
  finding.got = describe(back.states.back());
  if (!moved)
    finding.diagnoses.emplace_back(
        "on its way it is further from the truth than half of what a straight line is");
  if (!finding.held) {
    finding.hint = hint;
    const Path again = student.run(turned, -h, steps_there, steps_there, force, function);
    if (distance(again.states.back(), home) <= tolerance.value)
      finding.diagnoses.emplace_back(
          "the program that went there finds the way back, and another does not: what is noted "
          "down?");
  }
  check(finding);
}

}  // namespace judge
