// SPDX-License-Identifier: MIT-0
#include "judge/session.h"

#include <algorithm>
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
#include "judge/student.h"

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
    session().programs.clear();
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

// Returns whether what was wrong is right in a program that has just begun.
bool is_remembered() {
  const Exchange* wrong = Known::first_wrong(session().exercise, session().programs);
  if (!wrong || !wrong->evaluations.empty()) return false;
  Exchange alone = *wrong;
  Student fresh;
  alone.answer = fresh.call(alone.function, alone.arguments, alone.answer.size());
  return Known::is_right(session().exercise, alone);
}

// The diagnoses: a known wrong way's first, then what the judge says besides, but for the same
// again.
std::vector<std::string> with_known(const std::vector<std::string>& others) {
  std::vector<std::string> all = Known::recognised(session().exercise, session().programs);
  if (all.empty() && is_remembered())
    all = {"in a program that has just begun this is right: what is remembered?"};
  const std::string known = all.empty() ? "" : all[0];
  for (const std::string& other : others)
    if (known.empty() || (!other.starts_with(known) && known.find(other) == known.npos))
      all.push_back(other);
  return all;
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
  session().exercise = exercise;
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

// Of the hundreds that may hold, a report needs no more than a dozen.
void check(grade::Finding finding) {
  constexpr std::size_t most = 12;
  const bool held = finding.held;
  auto& findings = session().tests.back().findings;
  if (findings.size() >= most) findings.pop_back();
  if (!held && session().diagnoses) finding.diagnoses = with_known(finding.diagnoses);
  findings.push_back(std::move(finding));
  REQUIRE(held);
}

}  // namespace judge
