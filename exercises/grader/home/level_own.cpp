// SPDX-License-Identifier: MIT-0
#include "home/level_own.h"

#include <algorithm>
#include <cstdio>
#include <optional>

#include "exit_codes.h"
#include "format_values.h"
#include "grade_command.h"
#include "home/answers.h"
#include "home/own_command.h"
#include "home/own_driver.h"
#include "judge/session.h"
#include "level/part.h"
#include "printable.h"
#include "report/wrapped.h"
#include "without_a_cage.h"

namespace grade {
namespace {

/// What became of a part.
struct Outcome {
  bool is_there = false, kept = false;
  std::string says;
};

Request patient(const Command& command, const Answer& answer) {
  Request request = command.request;
  request.exercise = answer.exercise;
  request.submission = answer.file;
  request.run_limits.processor = 60;
  request.run_limits.wall = 180;
  return request;
}

std::string said_of(const level::Part& part, const level::Hour& hour) {
  if (!hour.whole) return "it explodes" + (hour.where.empty() ? "" : ", " + hour.where);
  std::string text =
      (hour.off < 1e-6 ? "less than 0.001" : number(1000 * hour.off, 2)) + " mm off at most";
  if (!hour.where.empty() && hour.off > level::most_off) text += ", " + hour.where;
  if (part.most_evaluations > 0)
    text += "; " + number(hour.evaluations, 3) + " evaluations a frame, where " +
            number(part.most_evaluations, 2) + " may be had";
  return text;
}

/// An hour of a part with the header that is there.
Outcome played(const Command& command, const level::Part& part, const Answer& answer) {
  const OwnDriver own(patient(command, answer));
  if (!own.why_not.empty()) return {true, false, own.why_not};
  judge::Session& session = judge::session();
  session = {};
  session.seed = command.request.seed;
  session.exercise = part.exercise;
  session.remembers = false;
  try {
    judge::Student right = begin_right(part.exercise), yours = own.begin();
    const level::Hour hour = part.hour(yours, right);
    return {true, level::is_kept(part, hour), said_of(part, hour)};
  } catch (const judge::Stopped&) {
    return {true, false, session.why};
  }
}

Outcome outcome(const Command& command, const level::Part& part, const std::vector<Answer>& there) {
  const auto answer =
      std::ranges::find(there, part.exercise, [](const Answer& one) { return one.exercise.name; });
  if (answer != there.end()) return played(command, part, *answer);
  return {false, false, "not here yet: " + own_command({"start", exercise(part.exercise)->task()})};
}

void show(const level::Part& part, const Outcome& outcome) {
  std::string head = part.name + ", " + part.does;
  head.resize(std::max<std::size_t>(44, head.size()), ' ');
  const std::string word = !outcome.is_there ? "-      " : outcome.kept ? "kept   " : "not    ";
  std::printf("%s%s\n    %s", word.c_str(), head.c_str(), wrapped(outcome.says, 4).c_str());
  std::fflush(stdout);
}

}  // namespace

int play_level(const Command& command) {
  Command here = command;
  do_without_a_cage_that_cannot_be_had(here.request);
  const std::vector<Answer> there = answers(command.own.empty() ? "." : command.own);
  std::printf(
      "The level, for an hour: twenty minutes at 60 frames a second, twenty at 30, and twenty in\n"
      "uneven frames. A producer wants it whole, and each thing within %s mm.\n\n",
      number(1000 * level::most_off, 2).c_str());
  std::size_t kept = 0;
  for (const level::Part& part : level::parts()) {
    const Outcome seen = outcome(here, part, there);
    show(part, seen);
    kept += seen.kept;
  }
  std::printf("\n%zu of %zu are kept.\n", kept, level::parts().size());
  return command.exit_by_verdict && kept < level::parts().size() ? Exit::below_full_score
                                                                 : Exit::graded;
}

}  // namespace grade
