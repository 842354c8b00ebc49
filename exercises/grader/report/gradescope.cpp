// SPDX-License-Identifier: MIT-0
#include "report/gradescope.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "printable.h"
#include "report/words.h"

namespace grade {
namespace {

using Json = nlohmann::ordered_json;

std::string output(const TestResult& test) {
  if (!test.ran) return "Not run, since an earlier test ended abnormally.";
  std::string text;
  for (const Finding& finding : test.findings) {
    if (finding.held) continue;
    for (const Line& line : lines(finding)) text += line.label + ": " + printable(line.text) + "\n";
  }
  return text;
}

Json json(const TestResult& test, std::size_t number) {
  return {{"number", std::to_string(number)},
          {"name", printable(test.name)},
          {"score", earned(test)},
          {"max_score", test.points},
          {"status", test.ran && test.held ? "passed" : "failed"},
          {"output", output(test)},
          {"output_format", "text"},
          {"visibility", "after_published"}};
}

std::string summary(const Report& report) {
  std::string text = printable(report.exercise) + ": " + headline(report) + "\n" +
                     std::string(sentence(report.verdict)) + "\n";
  for (const std::string& more : {report.why, report.memory, report.warnings}) {
    if (!more.empty()) text += printable(more) + "\n";
  }
  return text + "Graded by grader " + report.version + ".\n";
}

/// Of the student's own file, and nothing of the tests.
bool shows_at_once(Verdict verdict) {
  constexpr Verdict all[] = {Verdict::rejected, Verdict::compile_error, Verdict::compile_limit,
                             Verdict::link_error};
  return std::ranges::find(all, verdict) != std::end(all);
}

Json receipt(const Report& report) {
  const bool refused = shows_at_once(report.verdict);
  const std::string compiles = "It is there and compiles. Points come with the marks.";
  return {{"name", printable(report.exercise)},
          {"status", refused ? "failed" : "passed"},
          {"output", refused ? std::string(sentence(report.verdict)) + "\n" + printable(report.why)
                             : compiles},
          {"output_format", "text"},
          {"visibility", "visible"}};
}

}  // namespace

// Nothing shows before the marks do: what was asked would help others. The seed never shows.
std::string gradescope(const Report& report) {
  Json all{{"score", report.score},
           {"execution_time", std::isfinite(report.seconds) ? report.seconds : 0},
           {"output", summary(report)},
           {"output_format", "text"},
           {"visibility", "after_published"},
           {"stdout_visibility", "hidden"},
           {"tests", Json::array()}};
  for (const TestResult& test : report.tests) {
    all["tests"].push_back(json(test, all["tests"].size() + 1));
  }
  return all.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

std::string gradescope(const std::vector<Report>& reports) {
  Json all{{"score", 0},
           {"output", ""},
           {"output_format", "text"},
           {"visibility", "after_published"},
           {"stdout_visibility", "hidden"},
           {"tests", Json::array()}};
  int score = 0;
  std::string output;
  for (const Report& report : reports) {
    score += report.score;
    output += summary(report) + "\n";
    all["tests"].push_back(receipt(report));
    for (const TestResult& test : report.tests) {
      Json one = json(test, 0);
      one.erase("number");  // they are counted by whoever shows them
      one["name"] = printable(report.exercise + ": " + test.name);
      all["tests"].push_back(one);
    }
  }
  all["score"] = score;
  all["output"] = output;
  return all.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

}  // namespace grade
