// SPDX-License-Identifier: MIT-0
#include <algorithm>

#include "format_values.h"
#include "judge/case.h"
#include "judge/describe.h"
#include "judge/diagnose.h"
#include "judge/session.h"
#include "judge/tests.h"

namespace judge {
namespace {

using grade::number;

// The evaluations of the method, had it come to the student's own states: a path that is wrong
// for another reason is another test's.
std::vector<Evaluation> places(const Method& method, const Path& yours, const Case& with) {
  std::vector<Evaluation> all;
  for (std::size_t n = 0; n + 1 < yours.states.size(); ++n) {
    const Start start{yours.states[n].x, yours.states[n].v, yours.time(n)};
    const Path step = watch(method, start, with.h, 1, with.force);
    all.insert(all.end(), step.evaluations.begin(), step.evaluations.end());
  }
  return all;
}

}  // namespace

void evaluates(Student& student, const Method& method, int per_step, int to_begin,
               const std::string& hint, int function) {
  Random random;
  const Case with = draw(random);
  const Path yours = student.watch(with.start, with.h, case_steps, with.force, function);
  Path expected = watch(method, with.start, with.h, case_steps, with.force);
  // A method that carries its last evaluation along cannot be begun anew at each state.
  if (to_begin == 0) expected.evaluations = places(method, yours, with);
  const auto wanted = static_cast<std::size_t>(per_step * case_steps + to_begin);
  const std::vector<std::string> wrong_places = asked_elsewhere(yours, expected);

  grade::Finding finding;
  finding.held = yours.evaluations.size() == wanted && wrong_places.empty();
  finding.asked = std::to_string(case_steps) + " steps of " + method.name + " with " +
                  std::to_string(wanted) + " evaluations of the acceleration, where it has them";
  finding.input = describe(with.start) + ", h = " + number(with.h, 17);
  finding.expected = std::to_string(wanted) + " evaluations, where " + method.name + " has them";
  finding.got = std::to_string(yours.evaluations.size()) + " evaluations" +
                (wrong_places.empty() ? "" : ", some of them elsewhere");
  finding.error = yours.evaluations.size() == wanted ? "another place"
                                                     : std::to_string(yours.evaluations.size()) +
                                                           " instead of " + std::to_string(wanted);
  finding.tolerance = "none";
  finding.tolerance_from = "evaluations are counted, and their places compared to ten digits";
  if (!finding.held) {
    finding.hint = hint;
    finding.diagnoses = wrong_places;
  }
  check(finding);
}

}  // namespace judge
