// SPDX-License-Identifier: MIT-0
#include "task.h"

#include <cstdio>
#include <sstream>

#include "home/done.h"
#include "judge/session.h"
#include "report/files.h"

namespace grade {
namespace {

// The rest of a line that starts like this; empty if it starts otherwise.
std::string behind(const std::string& line, const std::string& start) {
  return line.starts_with(start) ? line.substr(start.size()) : "";
}

int points_of(const Exercise& exercise) {
  int sum = 0;
  for (const TestResult& test : judge::tests_of(exercise.name)) sum += test.points;
  return sum;
}

}  // namespace

Task task(const Exercise& exercise) {
  Task task;
  std::istringstream file(read_whole(exercise.folder / "task.md").value_or(""));
  for (std::string line; std::getline(file, line) && !line.empty();) {
    task.title += behind(line, "# ");
    task.goal += behind(line, "Goal: ");
    task.kind += behind(line, "Kind: ");
    task.difficulty += behind(line, "Difficulty: ");
    task.minutes += behind(line, "Minutes: ");
  }
  return task;
}

std::string list_of_exercises(const std::string& part) {
  std::string text;
  for (const Exercise& exercise : exercises()) {
    if (exercise.name.find(part) == std::string::npos) continue;
    const Task about = task(exercise);
    if (about.title.empty()) {
      text += exercise.name + "\n";
      continue;
    }
    char line[256];
    std::snprintf(line, sizeof line, "%-4s %-36s %-9s level %s %3s min  %2d points  %s\n",
                  is_done(exercise) ? "done" : "", exercise.name.c_str(), about.kind.c_str(),
                  about.difficulty.c_str(), about.minutes.c_str(), points_of(exercise),
                  about.title.c_str());
    text += line;
  }
  return text;
}

}  // namespace grade
