// SPDX-License-Identifier: MIT-0
#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "report/json.h"
#include "report/words.h"

namespace grade {
namespace {

using Json = nlohmann::json;

Finding finding_from(const Json& all) {
  Finding finding;
  all.at("held").get_to(finding.held);
  all.at("asked").get_to(finding.asked);
  all.at("input").get_to(finding.input);
  all.at("expected").get_to(finding.expected);
  all.at("got").get_to(finding.got);
  all.at("error").get_to(finding.error);
  all.at("tolerance").get_to(finding.tolerance);
  all.at("tolerance_from").get_to(finding.tolerance_from);
  all.at("hint").get_to(finding.hint);
  all.at("diagnoses").get_to(finding.diagnoses);
  if (all.contains("plot")) {
    all.at("plot").at("file").get_to(finding.plot.file);
    all.at("plot").at("title").get_to(finding.plot.title);
  }
  return finding;
}

TestResult test_from(const Json& all) {
  TestResult test;
  all.at("name").get_to(test.name);
  all.at("points").get_to(test.points);
  all.at("ran").get_to(test.ran);
  all.at("held").get_to(test.held);
  for (const Json& finding : all.at("findings")) test.findings.push_back(finding_from(finding));
  return test;
}

/// A number that is not finite stands in JSON as null.
double seconds(const Json& number) {
  return number.is_null() ? 0 : number.get<double>();
}

std::uint64_t seed_from(const std::string& digits) {
  std::uint64_t seed = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stopped, problem] = std::from_chars(digits.data(), end, seed);
  if (problem != std::errc() || stopped != end) throw std::invalid_argument("not a seed");
  return seed;
}

cage::Sandbox sandbox_from(const std::string& word) {
  for (const auto sandbox : {cage::Sandbox::bubblewrap, cage::Sandbox::none}) {
    if (name(sandbox) == word) return sandbox;
  }
  throw std::invalid_argument("not a sandbox");
}

Report report_from(const Json& all) {
  if (all.at("schema") != report_schema) throw std::invalid_argument("another schema");
  Report report;
  all.at("exercise").get_to(report.exercise);
  all.at("grader").get_to(report.version);
  all.at("submission").get_to(report.submission);
  all.at("sha256").get_to(report.sha256);
  report.seed = seed_from(all.at("seed"));
  report.sandbox = sandbox_from(all.at("sandbox"));
  report.verdict = verdict_named(all.at("verdict").get<std::string>()).value();
  all.at("score").get_to(report.score);
  all.at("points").get_to(report.points);
  all.at("why").get_to(report.why);
  all.at("warnings").get_to(report.warnings);
  all.at("ignored").get_to(report.ignored);
  all.at("unreadable").get_to(report.unreadable);
  all.at("try_again").get_to(report.try_again);
  for (const Json& test : all.at("tests")) report.tests.push_back(test_from(test));
  const Json& times = all.at("volatile");
  report.seconds = seconds(times.at("seconds"));
  report.compile_seconds = seconds(times.at("compile_seconds"));
  report.run_seconds = seconds(times.at("run_seconds"));
  return report;
}

}  // namespace

std::optional<Report> report_from(std::string_view text) {
  try {
    return report_from(Json::parse(text));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace grade
