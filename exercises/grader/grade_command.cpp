// SPDX-License-Identifier: MIT-0
#include "grade_command.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "exit_codes.h"
#include "home/done.h"
#include "home/own_command.h"
#include "home/run_own.h"
#include "installed.h"
#include "judge/session.h"
#include "printable.h"
#include "report/terminal.h"
#include "time_limits.h"
#include "without_a_cage.h"

namespace grade {
namespace {

bool met_a_time_limit(const Report& report) {
  return report.verdict == Verdict::compile_limit || report.verdict == Verdict::time_limit;
}

/// Keeps a file that is not the grader's own from being lost.
/// @throws Usage
void refuse_foreign_files(const std::filesystem::path& out) {
  const std::string name = foreign_file(out);
  if (name.empty()) return;
  throw Usage("'" + printable_name(out.string()) + "' holds a " + name +
              " that is not the grader's own; name another folder with --out");
}

/// Returns whether no point was lost that the grader might be to blame for: nothing of the
/// student's was compiled, or all of it was right.
bool needs_no_calibration(const Report& report) {
  return report.verdict == Verdict::accepted || report.verdict == Verdict::rejected ||
         report.verdict == Verdict::grader_error;
}

Report not_graded(const Report& report, const Obstacle& obstacle) {
  Report none = report;
  none.verdict = Verdict::grader_error;
  none.why = obstacle.why;
  none.try_again = obstacle.try_again;
  none.warnings.clear();
  none.tests = judge::tests_of(report.exercise);
  none.score = 0;
  return none;
}

/// Before anybody loses a point, the exercise's own solution has to earn all of them in the same
/// cage. Where that shows that this machine is slow, a submission that met a limit of time has
/// another go, and keeps these limits. A class has done all this before it named limits.
Report grade_fairly(Command& command) {
  const auto so_far = [&](const Report& report) {
    if (command.out) keep_provisional(report, *command.out, command.emits);
  };
  Report report = grade_submission(command.request, so_far);
  if (command.limits_given || needs_no_calibration(report)) return report;
  Request calibrated = command.request;
  if (const auto obstacle = calibrate(calibrated)) return not_graded(report, *obstacle);
  const bool slow = write_limits(calibrated) != write_limits(command.request);
  command.request = calibrated;
  return slow && met_a_time_limit(report) ? grade_submission(calibrated, so_far) : report;
}

/// From where it was called. The students of a class will call it from where they are.
Place place(const Command& command) {
  if (command.limits_given) return {};
  return {own_name(), command.request.submission.string()};
}

/// What else a student may do with it.
void print_offers(const Graded& graded) {
  const std::string task = exercise(graded.report.exercise)->task();
  if (graded.report.verdict == Verdict::accepted)
    std::printf("See it move: %s\nOther ways:  %s\n",
                own_command({"play", graded.place.file}).c_str(),
                own_command({"ways", task}).c_str());
  else if (is_judged(graded.report.verdict))
    std::printf("A hint: %s\n", own_command({"hint", task}).c_str());
}

}  // namespace

bool in_colour() {
  return isatty(STDOUT_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr;
}

Graded grade_one(Command command) {
  if (command.at_home || command.cage_if_any) do_without_a_cage_that_cannot_be_had(command.request);
  const bool done_before = !command.unchecked && is_done(command.request.exercise);
  // A class has folders of its own.
  if (command.out && !command.limits_given) refuse_foreign_files(*command.out);
  if (command.out) keep_provisional(blank_report(command.request), *command.out, command.emits);
  Graded graded{grade_fairly(command), place(command), command.limits_given};
  Report& report = graded.report;
  if (command.out) keep(report, *command.out, command.emits, graded.place);
  if (!command.unchecked) {
    check_memory(command.request, report);
    if (command.out && !report.memory.empty())
      keep(report, *command.out, command.emits, graded.place);
  }
  if (report.verdict == Verdict::accepted && !command.unchecked && !done_before)
    note_done(command.request.exercise);
  return graded;
}

void print(const Graded& graded, bool all) {
  if (graded.report.unreadable) {
    refuse(Exit::unreadable, printable(graded.report.why));
    return;
  }
  std::fputs(terminal(graded.report, in_colour(), all, graded.place).c_str(), stdout);
  if (!graded.of_a_class) print_offers(graded);
}

int grade_and_report(const Command& command) {
  const Graded graded = grade_one(command);
  print(graded, command.all);
  return exit_code(graded.report, command.exit_by_verdict);
}

int run_and_print(const Command& command) {
  Request request = command.request;
  do_without_a_cage_that_cannot_be_had(request);
  const Ran ran = run_own(command.own, request.sandbox);
  std::fputs(printable(ran.out).c_str(), stdout);
  std::fflush(stdout);
  std::fputs(printable(ran.err).c_str(), stderr);
  if (ran.why.empty()) return Exit::graded;
  return refuse(ran.unreadable ? Exit::unreadable : Exit::did_not_run, printable(ran.why));
}

}  // namespace grade
