// SPDX-License-Identifier: MIT-0
#include "judge/session.h"

#include <catch2/catch_session.hpp>
#include <catch2/catch_test_case_info.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/interfaces/catch_interfaces_testcase.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>
#include <catch2/reporters/catch_reporter_streaming_base.hpp>
#include <charconv>
#include <cmath>
#include <system_error>

#include "format_values.h"

namespace judge {
namespace {

using grade::TestResult;

// The tag [4 points].
int points(const Catch::TestCaseInfo& test) {
  constexpr std::string_view unit = " point";
  for (const Catch::Tag& tag : test.tags) {
    const std::string_view text(tag.original.data(), tag.original.size());
    const std::size_t end = text.find(unit);
    int value = 0;
    if (end != text.npos &&
        std::from_chars(text.data(), text.data() + end, value).ec == std::errc()) {
      return value;
    }
  }
  return 0;
}

TestResult described(const Catch::TestCaseInfo& test) {
  return {.name = test.name, .points = points(test), .findings = {}};
}

// Keeps what the tests find, and writes nothing.
class Reporter : public Catch::StreamingReporterBase {
 public:
  using StreamingReporterBase::StreamingReporterBase;
  static std::string getDescription() { return "keeps what an exercise's tests find"; }

  void testCaseStarting(const Catch::TestCaseInfo& test) override {
    session().tests.push_back(described(test));
  }

  void assertionEnded(const Catch::AssertionStats& stats) override {
    TestResult& test = session().tests.back();
    if (stats.assertionResult.isOk() || session().stopped()) return;
    if (!test.findings.empty() && !test.findings.back().held) return;
    grade::Finding plain;
    plain.asked = stats.assertionResult.getExpressionInMacro();
    plain.got = stats.assertionResult.getExpandedExpression();
    test.findings.push_back(plain);
  }

  void testCaseEnded(const Catch::TestCaseStats& stats) override {
    TestResult& test = session().tests.back();
    test.ran = !session().stopped();
    test.held = test.ran && stats.totals.assertions.allOk() && stats.totals.assertions.passed > 0;
  }
};

CATCH_REGISTER_REPORTER("judge", Reporter)

std::vector<TestResult> listed(const std::string& exercise) {
  std::vector<TestResult> tests;
  for (const auto& test : Catch::getRegistryHub().getTestCaseRegistry().getAllInfos()) {
    for (const Catch::Tag& tag : test->tags) {
      if (tag.original == Catch::StringRef(exercise)) tests.push_back(described(*test));
    }
  }
  return tests;
}

// A name as Catch2 takes it literally, with no character that means something there.
std::string escaped(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (std::string_view("\\,[\"").find(c) != std::string_view::npos) text += '\\';
    text += c;
  }
  return text;
}

}  // namespace

Session& session() {
  static Session session;
  return session;
}

std::vector<TestResult> tests_of(const std::string& exercise) {
  return listed(exercise);
}

void run_tests(const std::string& exercise) {
  static Catch::Session catch_session;
  session().tests.clear();
  Catch::ConfigData config;
  config.testsOrTags = {escaped(session().only) + "[" + exercise + "]"};
  config.reporterSpecifications = {*Catch::parseReporterSpec("judge")};
  config.runOrder = Catch::TestRunOrder::Declared;
  config.noThrow = false;
  catch_session.useConfigData(config);
  catch_session.run();
}

grade::Finding off_by(double off, const Tolerance& tolerance, const std::string& unit) {
  grade::Finding finding;
  finding.held = off <= tolerance.value && std::isfinite(tolerance.value);
  finding.error = grade::number(off, 3) + unit;
  finding.tolerance = grade::number(tolerance.value, 2) + unit;
  finding.tolerance_from = tolerance.from;
  return finding;
}

void check(grade::Finding finding) {
  const bool held = finding.held;
  session().tests.back().findings.push_back(std::move(finding));
  REQUIRE(held);
}

}  // namespace judge
