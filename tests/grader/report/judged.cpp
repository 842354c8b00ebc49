// SPDX-License-Identifier: MIT-0
#include "judged.h"

#include <catch2/catch_test_macros.hpp>
#include <utility>

using namespace grade;

namespace {

TestResult test(bool held, const std::string& got) {
  TestResult result{"a test", 4, true, held, {Finding{}}};
  result.findings[0].held = held;
  result.findings[0].got = got;
  return result;
}

Judged run(Verdict verdict, std::vector<TestResult> tests) {
  return {verdict, "", std::move(tests)};
}

}  // namespace

TEST_CASE("Of three runs that come to the same, nothing is said") {
  const Judged same = run(Verdict::partial, {test(true, "1"), test(false, "2")});
  const Judged judged = worst({same, same, same});
  CHECK(judged.why.empty());
  CHECK(judged.score() == 4);
}

TEST_CASE("A lottery gets the worst of its runs and is told so") {
  const Judged won = run(Verdict::accepted, {test(true, "1"), test(true, "2")});
  const Judged lost = run(Verdict::partial, {test(true, "1"), test(false, "7")});
  const Judged judged = worst({won, lost, won});
  CHECK(judged.score() == 4);
  CHECK(judged.verdict == Verdict::partial);
  CHECK(judged.why.find("your answer is random") != std::string::npos);
  CHECK(judged.why.find("8, 4 and 8 points") != std::string::npos);
}

TEST_CASE("Wrong answers that change from run to run are random too") {
  const Judged one = run(Verdict::wrong_answer, {test(false, "1")});
  const Judged other = run(Verdict::wrong_answer, {test(false, "2")});
  CHECK(worst({one, one, other}).why.find("0, 0 and 0 points") != std::string::npos);
}

TEST_CASE("Right answers may differ in what nobody marks") {
  const Judged one = run(Verdict::accepted, {test(true, "1")});
  const Judged other = run(Verdict::accepted, {test(true, "1.0000000000000002")});
  CHECK(worst({one, other}).why.empty());
}
