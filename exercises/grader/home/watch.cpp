// SPDX-License-Identifier: MIT-0
#include "home/watch.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

#include "exit_codes.h"
#include "grade_command.h"
#include "home/answers.h"
#include "home/done.h"
#include "home/own_command.h"
#include "printable.h"
#include "report/terminal.h"
#include "report/wrapped.h"

namespace grade {
namespace {

/// The first exercise of the book that is not done.
Exercise next_in_the_book() {
  const std::vector<Exercise> all = exercises();
  const auto next = std::ranges::find_if_not(all, is_done);
  return next != all.end() ? *next : all.front();
}

std::string bar_of_all() {
  const std::vector<Exercise> all = exercises();
  const auto done = static_cast<std::size_t>(std::ranges::count_if(all, is_done));
  return "[" + std::string(done, '#') + std::string(all.size() - done, '.') + "] " +
         std::to_string(done) + " of " + std::to_string(all.size()) + " exercises done\n\n";
}

std::string how_to_begin() {
  return own_command({"start", next_in_the_book().task()});
}

void show_on_empty_screen(const std::string& text) {
  std::printf("\x1b[H\x1b[2J\x1b[3J%s", text.c_str());
  std::fflush(stdout);
}

Graded grade_answer(const Command& command, const Answer& answer) {
  Command one = command;
  one.request.exercise = answer.exercise;
  one.request.submission = answer.file.lexically_normal();
  return grade_one(one);
}

/// Headers that have no exercise's name, for whoever waits for one of them to be graded.
std::string others_here() {
  std::string names;
  for (const auto& entry : std::filesystem::directory_iterator(".")) {
    const std::string name = entry.path().filename().string();
    const auto has_name = [&](const Exercise& one) { return one.header() == name; };
    if (name.ends_with(".h") && std::ranges::none_of(exercises(), has_name))
      names += (names.empty() ? "" : ", ") + printable_name(name);
  }
  return names.empty() ? "" : wrapped("No exercise is called like " + names + ".", 0);
}

void show(const Command& command, const Answer& answer) {
  const Graded seen = grade_answer(command, answer);
  show_on_empty_screen(bar_of_all());
  if (seen.report.verdict == Verdict::accepted || command.all || seen.report.unreadable) {
    print(seen, command.all);
  } else {
    std::fputs(on_one_screen(seen.report, in_colour()).c_str(), stdout);
    std::printf("A hint: %s\n", own_command({"hint", answer.exercise.task()}).c_str());
  }
  std::printf("%sSave it again, and it is graded again. Ctrl-C ends this.\n",
              others_here().c_str());
  std::fflush(stdout);
}

/// Waits until an answer has been saved since, and has kept still for a moment: an editor may be
/// writing it.
/// @param before  the answers as they were; learns of the one that is returned
Answer wait_for_saved(std::vector<Answer>& before) {
  constexpr std::chrono::milliseconds moment(100);
  while (true) {
    std::vector<Answer> last, now = answers(".");
    do {
      std::this_thread::sleep_for(moment);
      last = std::exchange(now, answers("."));
    } while (last != now);
    const auto saved = std::ranges::find_if(now, [&](const Answer& answer) {
      return std::ranges::find(before, answer) == before.end();
    });
    if (saved == now.end()) continue;
    // Others that were saved meanwhile have their turn.
    std::erase_if(before, [&](const Answer& answer) { return answer.file == saved->file; });
    before.push_back(*saved);
    return *saved;
  }
}

}  // namespace

int watch(const Command& command) {
  std::vector<Answer> before = answers(".");
  if (isatty(STDOUT_FILENO) == 0) {
    if (before.empty())
      return refuse(Exit::bad_input, "there is no answer here; begin by " + how_to_begin() +
                                         ", or name an exercise and a file");
    const Graded only = grade_answer(command, before.front());
    print(only, command.all);
    return exit_code(only.report, command.exit_by_verdict);
  }
  if (before.empty()) {
    show_on_empty_screen(bar_of_all() + "There is no answer in this folder yet. Begin with\n  " +
                         how_to_begin() + "\nin another terminal. Ctrl-C ends this.\n");
  } else {
    show(command, before.front());
  }
  while (true) show(command, wait_for_saved(before));
}

}  // namespace grade
