// SPDX-License-Identifier: MIT-0
#include "one.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "report/escape.h"
#include "report/terminal.h"
#include "time_limits.h"

namespace grade {
namespace {

bool met_a_time_limit(const Report& report) {
  return report.verdict == Verdict::compile_limit || report.verdict == Verdict::time_limit;
}

/// A submission that met a limit of time has it measured whether this machine is slow, and then has
/// another go: limits are calibrated only where it makes a difference.
Report grade_patiently(const Command& command) {
  Report report = grade_one(command.request);
  if (command.limits_given || !met_a_time_limit(report)) return report;
  Request calibrated = command.request;
  calibrate(calibrated);
  const bool slow = write_limits(calibrated) != write_limits(command.request);
  return slow ? grade_one(calibrated) : report;
}

int exit_code(const Report& report, bool by_verdict) {
  if (report.unreadable) return Exit::unreadable;
  if (report.verdict == Verdict::grader_error) {
    return report.try_again ? Exit::try_again : Exit::failed;
  }
  return by_verdict && report.score < report.points ? Exit::below_full_score : Exit::graded;
}

void print(const Report& report) {
  if (report.unreadable) {
    std::fprintf(stderr, "grade: %s\n", printable(report.why).c_str());
    return;
  }
  const bool colour = isatty(STDOUT_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr;
  std::fputs(terminal(report, colour).c_str(), stdout);
}

}  // namespace

int grade_and_report(const Command& command) {
  const std::string version = grade::version(command.request.exercise);
  if (command.out) keep_provisional(command.request, version, *command.out, command.emits);
  Report report = grade_patiently(command);
  if (command.out) keep(report, *command.out, command.emits);
  print(report);
  return exit_code(report, command.exit_by_verdict);
}

}  // namespace grade
