// SPDX-License-Identifier: MIT-0
#include "grade_submission.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <span>
#include <stdexcept>
#include <system_error>

#include "compile.h"
#include "installed.h"
#include "judge/called.h"
#include "judge/driver.h"
#include "judge/session.h"
#include "judged.h"
#include "kit.h"
#include "memory_check.h"
#include "replace_all.h"
#include "report/files.h"
#include "submission.h"
#include "time_limits.h"
#include "version.h"

namespace grade {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string read(const std::filesystem::path& path) {
  if (const auto text = read_whole(path)) return *text;
  throw std::runtime_error("cannot read " + path.string());
}

Judged judge_once(const Request& request, const cage::Kit& kit, const cage::File& driver) {
  const judge::Caged caged{.kit = kit,
                           .driver = driver,
                           .sandbox = request.sandbox,
                           .limits = request.run_limits,
                           .longest = longest_run(request),
                           .arguments = request.arguments};
  judge::Session& session = judge::session();
  session = {};
  session.begin = [&] {
    return request.called ? judge::begin_called(request.called) : judge::begin_driver(caged);
  };
  session.seed = request.seed;
  session.only = request.only;
  session.diagnoses = request.diagnoses;
  judge::run_tests(request.exercise.name);
  Judged judged{session.ended, session.why, session.tests};
  if (!session.stopped()) judged.verdict = verdict(judged);
  return judged;
}

using SoFar = std::function<void(const Report&)>;

// Code that throws dice might win once.
void judge_driver(const Request& request, const cage::Kit& kit, const cage::File& driver,
                  Report& report, const SoFar& so_far = {}) {
  const auto start = Clock::now();
  std::vector<Judged> runs;
  do {
    runs.push_back(judge_once(request, kit, driver));
    const Judged judged = worst(runs);
    report.run_seconds = seconds_since(start);
    report.verdict = judged.verdict;
    report.why = judged.why;
    report.tests = judged.tests;
    report.score = judged.score();
    report.run_processor = std::max(report.run_processor, judge::session().processor);
    if (so_far) so_far(report);
  } while (static_cast<int>(runs.size()) < request.runs &&
           (is_judged(report.verdict) || report.score > 0));
}

// Everything from the path to the verdict; leaves in the report how far it came.
void grade_into(const Request& request, Report& report, const SoFar& so_far) {
  const Submission submission =
      read_submission(request.submission, request.exercise.chapter(), request.exercise.header());
  report.ignored = submission.ignored;
  report.unreadable = submission.unreadable;
  if (!submission.refused.empty()) {
    report.verdict = Verdict::rejected;
    report.why = submission.refused;
    return;
  }
  report.sha256 = sha256(submission.text);
  if (so_far) so_far(report);
  const cage::Kit kit = own_kit();
  if (request.sandbox == cage::Sandbox::bubblewrap) {
    if (const auto why = cage::unsafe(kit)) {
      report.why = *why;
      report.no_cage = true;
      return;
    }
  }
  const auto start = Clock::now();
  // The compiler's messages call it by the name that the student has for it.
  const std::string header = request.exercise.header();
  const std::string harness = read(request.exercise.folder / "harness.h");
  const Compiled compiled =
      compile(submission.text, header, harness, request.sandbox, kit, request.compile_limits);
  report.compile_seconds = seconds_since(start);
  report.compile_processor = compiled.processor;
  if (compiled.failed) {
    report.verdict = *compiled.failed;
    report.why = replace_all(compiled.message, header, submission.name);
    return;
  }
  report.warnings = replace_all(compiled.message, header, submission.name);
  judge_driver(request, kit, compiled.driver, report, so_far);
}

// Says what became of our own solution, in the words that a student would have read.
std::string failed_calibration(const Report& report) {
  std::string why = "the grader does not work on this machine: it gives its own " +
                    report.exercise + "/" +
                    std::filesystem::path(report.submission).filename().string() + " " +
                    std::string(name(report.verdict));
  for (const TestResult& test : report.tests)
    if (is_judged(report.verdict) && !test.held) why += ", " + test.name;
  return report.why.empty() ? why : why + ":\n" + report.why;
}

// Shortages that another try may not meet.
bool may_pass(int error) {
  return error == EAGAIN || error == ENOMEM || error == ENOSPC || error == EMFILE ||
         error == ENFILE;
}

// A report on the request, filled by `grade`. What goes wrong with us is a grader_error.
template <class Grade>
Report reported(const Request& request, const Grade& grade) {
  const auto start = Clock::now();
  Report report = blank_report(request);
  try {
    grade(request, report);
  } catch (const std::system_error& error) {
    report.verdict = Verdict::grader_error;
    report.why = error.what();
    report.try_again = may_pass(error.code().value());
  } catch (const std::exception& error) {
    report.verdict = Verdict::grader_error;
    report.why = error.what();
  }
  report.seconds = seconds_since(start);
  return report;
}

}  // namespace

Report grade_submission(const Request& request, const SoFar& so_far) {
  return reported(request,
                  [&](const Request&, Report& report) { grade_into(request, report, so_far); });
}

void check_memory(const Request& request, Report& report) {
  const bool ran = is_judged(report.verdict) || report.verdict == Verdict::runtime_error;
  if (!ran) return;
  const std::string header = request.exercise.header();
  const Submission now = read_submission(request.submission, request.exercise.chapter(), header);
  if (sha256(now.text) != report.sha256) return;  // somebody is writing it
  const auto start = Clock::now();
  try {
    report.memory =
        misused_memory(request, own_kit(), now.text, read(request.exercise.folder / "harness.h"));
  } catch (const std::exception&) {  // there is less to say, and the verdict stands
  }
  report.seconds += seconds_since(start);
}

Report grade_driver(const Request& request, const cage::File& driver) {
  return reported(request, [&](const Request&, Report& report) {
    judge_driver(request, own_kit(), driver, report);
  });
}

Report grade_called(const Request& request) {
  return grade_driver(request, {});
}

std::optional<Obstacle> calibrate(Request& request) {
  constexpr double times = 20;
  Request own = request;
  own.submission = request.exercise.folder / "solution.h";
  own.runs = 1;
  const bool at_home = !std::filesystem::exists(own.submission);
  if (at_home) own.submission = request.exercise.folder / "starter.h";
  for (cage::Limits* limits : {&own.compile_limits, &own.run_limits}) {
    limits->processor *= times;
    limits->wall *= times;
  }
  const Report report = grade_submission(own);
  if (!(at_home ? is_judged(report.verdict) : report.verdict == Verdict::accepted))
    return Obstacle{failed_calibration(report), report.try_again};
  const auto raise = [&](cage::Limits& limits, double seconds) {
    limits.processor = std::max(limits.processor, times * seconds);
    limits.wall = std::max(limits.wall, times * seconds + 5);
  };
  raise(request.compile_limits, report.compile_processor);
  raise(request.run_limits, report.run_processor);
  return std::nullopt;
}

std::optional<std::string> unsafe() {
  return cage::unsafe(own_kit());
}

std::string sha256(const std::string& text) {
  cage::Process sum({"sha256sum"}, {}, {});
  sum.send(std::as_bytes(std::span(text)));
  return sum.finish().out.substr(0, 64);
}

std::string version(const Exercise& exercise) {
  return std::ranges::find(versions(), exercise.name, &Version::exercise)->hash;
}

}  // namespace grade
