// SPDX-License-Identifier: MIT-0
// Catch2 runs the judges.
#include <catch2/catch_session.hpp>
#include <catch2/catch_test_case_info.hpp>
#include <catch2/interfaces/catch_interfaces_registry_hub.hpp>
#include <catch2/interfaces/catch_interfaces_testcase.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>
#include <catch2/reporters/catch_reporter_streaming_base.hpp>

#include "judge/points.h"
#include "judge/session.h"

namespace judge {
namespace {

using grade::TestResult;

int points(const Catch::TestCaseInfo& test) {
  int points = 0;
  for (const Catch::Tag& tag : test.tags)
    points += points_of(std::string_view(tag.original.data(), tag.original.size()));
  return points;
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
    session().programs.clear();
    session().given.clear();
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

std::vector<TestResult> tests_of(const std::string& exercise) {
  return listed(exercise);
}

void run_tests(const std::string& exercise) {
  static Catch::Session catch_session;
  session().tests.clear();
  session().exercise = exercise;
  Catch::ConfigData config;
  config.testsOrTags = {escaped(session().only) + "[" + exercise + "]"};
  config.reporterSpecifications = {*Catch::parseReporterSpec("judge")};
  config.runOrder = Catch::TestRunOrder::Declared;
  config.noThrow = false;
  catch_session.useConfigData(config);
  catch_session.run();
}

}  // namespace judge
