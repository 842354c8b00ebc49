// SPDX-License-Identifier: MIT-0
#include "class/summary.h"

#include <algorithm>

#include "report/words.h"

namespace grade {
namespace {

TestCount& counter(std::vector<TestCount>& counters, const TestResult& test) {
  const auto found = std::ranges::find(counters, test.name, &TestCount::name);
  return found != counters.end() ? *found : counters.emplace_back(test.name, test.points);
}

}  // namespace

ExerciseCount count(const Results& results, std::size_t exercise) {
  ExerciseCount all;
  for (std::size_t student = 0; student < results.students.size(); ++student) {
    if (!results.is_asked(student, exercise)) continue;
    const Report& report = results.report(student, exercise);
    ++all.verdicts[report.verdict];
    const bool judged = is_graded(report) && report.verdict != Verdict::rejected;
    all.judged += judged;
    for (const TestResult& test : report.tests) {
      counter(all.tests, test).held += judged && test.ran && test.held;
    }
  }
  return all;
}

}  // namespace grade
