// SPDX-License-Identifier: MIT-0
#include "course/equal.h"

#include <catch2/catch_test_macros.hpp>

using namespace grade;

namespace {

Finding failed(const std::string& got) {
  Finding finding;
  finding.asked = "one step from x = 0.11111111111111111";
  finding.input = "h = 0.22222222222222222";
  finding.expected = "0.33333333333333333";
  finding.got = got;
  return finding;
}

Report report_of(const Finding& finding, const std::string& sha256 = "") {
  Report report;
  report.exercise = "2-euler/orbit-drift";
  report.verdict = finding.held ? Verdict::accepted : Verdict::wrong_answer;
  report.sha256 = sha256;
  report.tests = {{"one step", 5, true, finding.held, {finding}},
                  {"five steps", 5, true, finding.held, {finding}}};
  return report;
}

/// `what: students: where` of each.
std::vector<std::string> found_in(const std::vector<Handed>& all,
                                  const std::set<std::string>& starters = {},
                                  const std::optional<Report>& starter = {}) {
  std::vector<std::string> texts;
  for (const EqualWork& one : equal_work(all, starters, starter)) {
    std::string text = one.what + ":";
    for (const std::string& student : one.students) text += " " + student;
    texts.push_back(text + ": " + one.where);
  }
  return texts;
}

using All = std::vector<std::string>;

}  // namespace

TEST_CASE("equal wrong numbers are named once for all tests that say them") {
  const Report same = report_of(failed("x = 0.12345678901234567")),
               other = report_of(failed("x = 0.12345678901234568"));
  CHECK(found_in({{"ada", same}, {"bob", other}, {"cy", same}}) ==
        All{"wrong numbers: ada cy: five steps; one step"});
}

TEST_CASE("right numbers, few digits and what the question holds are equal by nature") {
  Finding right = failed("0.12345678901234567");
  right.held = true;
  for (const Finding& finding :
       {right, failed("0"), failed("nan"), failed("-1.5"), failed("3 evaluations"), failed("0.25"),
        failed("0.33333333333333333 and 0.11111111111111111"), failed("100000000000000000")})
    CHECK(found_in({{"ada", report_of(finding)}, {"bob", report_of(finding)}}) == All{});
}

TEST_CASE("a mistake that the grader knows is many students' own") {
  Finding known = failed("0.12345678901234567");
  known.diagnoses = {"this is symplectic Euler"};
  CHECK(found_in({{"ada", report_of(known)}, {"bob", report_of(known)}}) == All{});
}

TEST_CASE("equal files are named with their verdict, right ones too, and not their numbers again") {
  Finding right;
  right.held = true;
  const Report wrong = report_of(failed("0.12345678901234567"), "aa");
  CHECK(found_in({{"ada", wrong}, {"bob", wrong}}) == All{"file: ada bob: WRONG_ANSWER"});
  const Report full = report_of(right, "bb");
  CHECK(found_in({{"ada", full}, {"bob", full}, {"cy", wrong}}) == All{"file: ada bob: ACCEPTED"});
  CHECK(found_in({{"ada", report_of(right)}, {"bob", report_of(right)}}) == All{});
}

TEST_CASE("the starter is nobody's own, neither its file nor its numbers") {
  const Report begun = report_of(failed("0.12345678901234567"), "aa");
  const Report remarked = report_of(failed("0.12345678901234567"), "bb");
  CHECK(found_in({{"ada", begun}, {"bob", begun}, {"cy", remarked}}, {"aa"}, begun) == All{});
  CHECK(found_in({{"ada", begun}, {"bob", begun}, {"cy", remarked}}, {"aa"}, {}) == All{});
  CHECK(found_in({{"ada", begun}, {"cy", remarked}}, {"cc"}, {}) ==
        All{"wrong numbers: ada cy: five steps; one step"});
}

TEST_CASE("a test that did not run says nothing") {
  Report ended = report_of(failed("0.12345678901234567"));
  for (TestResult& test : ended.tests) test.ran = false;
  CHECK(found_in({{"ada", ended}, {"bob", ended}}) == All{});
}

TEST_CASE("the table escapes what a spreadsheet would compute") {
  CHECK(equal_csv({{"a/b", "file", {"=1", "b,c"}, "ACCEPTED"}}) ==
        "exercise,equal,how many,students,where\r\na/b,file,2,\"'=1; b,c\",ACCEPTED\r\n");
}
