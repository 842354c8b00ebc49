// SPDX-License-Identifier: MIT-0
#include "report/gradescope.h"

#include <cmath>
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
  return text + provenance(report) + "\n";
}

}  // namespace

// Nothing shows before the marks do: what was asked, and with which seed, would help others.
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

}  // namespace grade
