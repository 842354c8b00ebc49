// SPDX-License-Identifier: MIT-0
#include "report/json.h"

#include <nlohmann/json.hpp>

#include "report/words.h"

namespace grade {
namespace {

using Json = nlohmann::ordered_json;

Json json(const Finding& finding) {
  Json all{{"held", finding.held},
           {"asked", finding.asked},
           {"input", finding.input},
           {"expected", finding.expected},
           {"got", finding.got},
           {"error", finding.error},
           {"tolerance", finding.tolerance},
           {"tolerance_from", finding.tolerance_from},
           {"hint", finding.hint},
           {"diagnoses", finding.diagnoses}};
  const Plot& plot = finding.plot;
  if (!plot.file.empty()) all["plot"] = {{"file", plot.file}, {"title", plot.title}};
  return all;
}

Json json(const TestResult& test) {
  Json all{{"name", test.name}, {"points", test.points}, {"score", earned(test)},
           {"ran", test.ran},   {"held", test.held},     {"findings", Json::array()}};
  for (const Finding& finding : test.findings) all["findings"].push_back(json(finding));
  return all;
}

Json json(const Report& report) {
  Json all{{"schema", report_schema},
           {"exercise", report.exercise},
           {"grader", report.version},
           {"submission", report.submission},
           {"sha256", report.sha256},
           {"seed", std::to_string(report.seed)},
           {"sandbox", name(report.sandbox)},
           {"verdict", name(report.verdict)},
           {"score", report.score},
           {"points", report.points},
           {"why", report.why},
           {"warnings", report.warnings},
           {"ignored", report.ignored},
           {"unreadable", report.unreadable},
           {"try_again", report.try_again},
           {"tests", Json::array()}};
  for (const TestResult& test : report.tests) all["tests"].push_back(json(test));
  all["volatile"] = {{"seconds", report.seconds},
                     {"compile_seconds", report.compile_seconds},
                     {"run_seconds", report.run_seconds}};
  return all;
}

/// GitHub takes `##[` for a command even in the middle of a line of JSON.
std::string without_commands(std::string text) {
  for (std::size_t at = 0; (at = text.find("##", at)) != std::string::npos;) {
    text.replace(at, 2, "#\\u0023");
  }
  return text;
}

}  // namespace

std::string to_json(const Report& report) {
  constexpr int indent = 2;
  constexpr bool ascii = true;
  return without_commands(json(report).dump(indent, ' ', ascii, Json::error_handler_t::replace)) +
         "\n";
}

}  // namespace grade
