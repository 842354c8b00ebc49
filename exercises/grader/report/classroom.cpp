// SPDX-License-Identifier: MIT-0
#include "report/classroom.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "printable.h"
#include "report/words.h"

namespace grade {
namespace {

using ClassroomJson = nlohmann::ordered_json;

/// 31 exercises of ten tests stay below what an environment variable may hold, in Base64, too.
constexpr std::size_t longest_message = 200;

std::string message_of(const Report& report, const TestResult& test) {
  std::string text(outcome(report, test));
  for (const Finding& finding : test.findings)
    if (!finding.held && !finding.error.empty()) text += ": off by " + finding.error;
  return printable(text, longest_message);
}

ClassroomJson as_step(const Report& report, const TestResult& test) {
  const bool held = earned(test) == test.points;
  return {{"name", printable(report.exercise + ": " + test.name)},
          {"status", held ? "pass" : "fail"},
          {"score", earned(test)},
          {"message", held ? ClassroomJson() : ClassroomJson(message_of(report, test))},
          {"test_code", "grade " + report.exercise},
          {"filename", ""},
          {"line_no", 0},
          {"duration", std::isfinite(report.run_seconds) ? 1000 * report.run_seconds : 0}};
}

}  // namespace

std::string classroom(const std::vector<Report>& reports) {
  int score = 0, points = 0;
  ClassroomJson tests = ClassroomJson::array();
  for (const Report& report : reports) {
    score += report.score;
    points += report.points;
    for (const TestResult& test : report.tests) tests.push_back(as_step(report, test));
  }
  const ClassroomJson all{{"version", 1},
                          {"status", score == points ? "pass" : "fail"},
                          {"max_score", points},
                          {"tests", tests}};
  return all.dump(-1, ' ', true, ClassroomJson::error_handler_t::replace) + "\n";
}

}  // namespace grade
