// SPDX-License-Identifier: MIT-0
#include "class/results.h"

#include <catch2/catch_test_macros.hpp>

#include "class/summary.h"
#include "time_limits.h"

using namespace grade;

namespace {

Report report_of(const std::string& version, std::uint64_t seed, Verdict verdict) {
  Report report;
  report.version = version;
  report.seed = seed;
  report.verdict = verdict;
  return report;
}

}  // namespace

TEST_CASE("reports of another grader or another seed do not stand in one table") {
  const Exercise exercise = exercises().front();
  const std::string now = version(exercise);
  std::vector<Job> jobs;
  for (const char* name : {"same", "older", "other seed", "none"}) {
    jobs.push_back({{name, name}, exercise, name});
  }
  const Results results{
      {},
      {exercise},
      {report_of(now, 1, Verdict::partial), report_of("older", 1, Verdict::accepted),
       report_of(now, 2, Verdict::rejected), report_of("older", 2, Verdict::grader_error)}};
  const std::vector<Job> old = stale(jobs, results, 1);
  REQUIRE(old.size() == 2);
  CHECK(old[0].student.name == "older");
  CHECK(old[1].student.name == "other seed");
}

TEST_CASE("a share is of those whose submission was judged") {
  const Exercise exercise = exercises().front();
  Results results{{}, {exercise}, {}};
  for (const Verdict verdict : {Verdict::accepted, Verdict::wrong_answer, Verdict::compile_error,
                                Verdict::rejected, Verdict::grader_error}) {
    Report report = report_of("v", 1, verdict);
    const bool held = verdict == Verdict::accepted, ran = held || verdict == Verdict::wrong_answer;
    report.tests = {{"a test", 3, ran, held, {}}};
    results.students.push_back({std::string(name(verdict)), {}});
    results.reports.push_back(report);
    results.asked.push_back(true);
  }
  const ExerciseCount all = count(results, 0);
  CHECK(all.judged == 3);
  REQUIRE(all.tests.size() == 1);
  CHECK(all.tests[0].held == 1);
  CHECK(all.tests[0].points == 3);
  CHECK(all.verdicts.size() == 5);
}

TEST_CASE("of what a compiler said the table has the line with the error") {
  const Exercise exercise = exercises().front();
  Report report = report_of("v", 1, Verdict::compile_error);
  report.why =
      "a.h: In function 'int f()':\na.h:20:25: error: 'nix' was not declared\n   20 | nix;";
  const Results results{{{"ada", {}}}, {exercise}, {report}, {true}};
  CHECK(report_csv(results).ends_with(",a.h:20:25: error: 'nix' was not declared\r\n"));
}

// A program's tests are those of an exercise if they bear its name: here this one, alone.
TEST_CASE("a deadline is long enough for all that may reach its limit", "[deadlines]") {
  Request request;
  request.exercise.name = "deadlines";
  request.runs = 3;
  request.compile_limits.wall = 30;
  request.run_limits.wall = 10;
  CHECK(longest_run(request) == 10);
  CHECK(longest_grading(request) >= 30 + 3 * 10);
  CHECK(longest_grading(request) <= 3 * (30 + 3 * 10));
}
