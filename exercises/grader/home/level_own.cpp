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
#include "home/play_page.h"
#include "judge/session.h"
#include "level/film.h"
#include "level/part.h"
#include "printable.h"
#include "replace_all.h"
#include "report/escape.h"
#include "report/files.h"
#include "report/wrapped.h"
#include "task.h"
#include "without_a_cage.h"

namespace grade {
namespace {

/// What became of a part.
struct Outcome {
  bool is_there = false, kept = false;
  std::string says;
  level::Paths yours{};  ///< in the film; empty if it does not come so far
};

const char* word(const Outcome& outcome) {
  return !outcome.is_there ? "-" : outcome.kept ? "kept" : "not";
}

constexpr const char* caption =
    "Ten seconds of the level in uneven frames: whatever is yours moves by your header, and as it "
    "should be beside it. What is not there yet moves by the book's. The replay is wound back in "
    "the second half, and the shuttle is asked ten times a second where it would land.";

Request patient(const Command& command, const Answer& answer) {
  Request request = command.request;
  request.exercise = answer.exercise;
  request.submission = answer.file;
  request.run_limits.processor = 60;
  request.run_limits.wall = 180;
  return request;
}

std::string distance(double metres) {
  if (metres >= 1000) return "more than a kilometre";
  if (metres >= 1) return number(metres, 3) + " m";
  return metres < 1e-6 ? "less than 0.001 mm" : number(1000 * metres, 3) + " mm";
}

std::string said_of(const level::Part& part, const level::Hour& hour) {
  if (!hour.whole) return "it explodes" + (hour.where.empty() ? "" : ", " + hour.where);
  std::string text = distance(hour.off) + " off at most";
  if (!hour.where.empty() && hour.off > level::most_off) text += ", " + hour.where;
  if (part.most_evaluations > 0)
    text += "; " + number(hour.evaluations, 3) + " evaluations a frame, where " +
            number(part.most_evaluations, 3) + " are allowed";
  return text;
}

void begin_session(const Command& command, const level::Part& part) {
  judge::Session& session = judge::session();
  session = {};
  session.seed = command.request.seed;
  session.exercise = part.exercise;
  session.remembers = false;
}

level::Paths filmed(const Command& command, const level::Part& part, const OwnDriver& own) {
  begin_session(command, part);
  try {
    judge::Student yours = own.begin();
    return part.paths(yours, level::film_frames());
  } catch (const judge::Stopped&) {
    return {};
  }
}

/// An hour of a part with the header that is there.
Outcome played(const Command& command, const level::Part& part, const Answer& answer) {
  const OwnDriver own(patient(command, answer));
  if (!own.why_not.empty()) return {true, false, own.why_not};
  begin_session(command, part);
  Outcome outcome{true, false, ""};
  try {
    judge::Student right = begin_right(part.exercise), yours = own.begin();
    const level::Hour hour = part.hour(yours, right);
    outcome.kept = level::is_kept(part, hour);
    outcome.says = said_of(part, hour);
  } catch (const judge::Stopped&) {
    outcome.says = judge::session().why;
  }
  outcome.yours = filmed(command, part, own);
  return outcome;
}

Outcome outcome(const Command& command, const level::Part& part, const std::vector<Answer>& there) {
  const auto answer =
      std::ranges::find(there, part.exercise, [](const Answer& one) { return one.exercise.name; });
  if (answer != there.end()) return played(command, part, *answer);
  return {false, false, "not here yet: " + own_command({"start", exercise(part.exercise)->task()})};
}

/// Several lines stay lines, as a compiler says them.
std::string as_said(const std::string& text) {
  if (text.find('\n') == std::string::npos) return wrapped(text, 4);
  return replace_all(printable(text), "\n", "\n    ") + "\n";
}

void show(const level::Part& part, const Outcome& outcome) {
  std::string head = part.name + ", " + part.does;
  head.resize(std::max<std::size_t>(44, head.size()), ' ');
  std::printf("%-7s%s\n    %s", word(outcome), head.c_str(), as_said(outcome.says).c_str());
  std::fflush(stdout);
}

level::Shown shown(const Command& command, const level::Part& part, const Outcome& outcome) {
  begin_session(command, part);
  judge::Student solution = begin_right(part.exercise);
  return {part, outcome.yours, part.paths(solution, level::film_frames())};
}

std::string row(const level::Part& part, const Outcome& outcome) {
  return "<tr><td>" + html(part.name) + "</td><td>" + word(outcome) + "</td><td>" +
         html(outcome.says) + "</td></tr>\n";
}

void write_page(const Command& command, const std::filesystem::path& page,
                const std::vector<Outcome>& outcomes) {
  Stage stage(level::film_view);
  std::vector<level::Shown> all;
  std::string rows;
  for (std::size_t n = 0; n < outcomes.size(); ++n) {
    const level::Part& part = level::parts()[n];
    all.push_back(shown(command, part, outcomes[n]));
    rows += row(part, outcomes[n]);
  }
  level::draw(stage, all, level::film_frames());
  write_whole(page, film_page("The level, yours", caption, stage,
                              "<h2>After an hour</h2>\n<div class=\"wide\"><table>" + rows +
                                  "</table></div>\n"));
}

}  // namespace

int play_level(const Command& command) {
  Command here = command;
  const std::filesystem::path folder = command.own.empty() ? "." : command.own;
  const std::filesystem::path page = (folder / "level.html").lexically_normal();
  if (!std::filesystem::is_directory(folder))
    throw Usage("there is no folder '" + printable_name(folder.string()) + "'");
  refuse_foreign_page(page);
  do_without_a_cage_that_cannot_be_had(here.request);
  const std::vector<Answer> there = answers(folder);
  std::printf(
      "The level, for an hour: twenty minutes at 60 frames a second, twenty at 30, and twenty in\n"
      "uneven frames. A producer wants it whole, and each thing within %s mm.\n"
      "It may take a minute.\n\n",
      number(1000 * level::most_off, 2).c_str());
  std::vector<Outcome> outcomes;
  for (const level::Part& part : level::parts()) {
    outcomes.push_back(outcome(here, part, there));
    show(part, outcomes.back());
  }
  const auto kept = std::ranges::count_if(outcomes, &Outcome::kept);
  write_page(here, page, outcomes);
  const bool all = static_cast<std::size_t>(kept) == outcomes.size();
  std::printf("\n%td of %zu are kept%s Open %s in a browser.\n", kept, outcomes.size(),
              all ? ": ship it." : ".", printable_name(page.string()).c_str());
  return command.exit_by_verdict && !all ? Exit::below_full_score : Exit::graded;
}

void list_level() {
  for (const level::Part& part : level::parts())
    std::fputs(list_of_exercises(part.exercise).c_str(), stdout);
}

}  // namespace grade
