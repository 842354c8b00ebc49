// SPDX-License-Identifier: MIT-0
#include "task.h"

#include <cstdio>
#include <sstream>

#include "done.h"
#include "report/files.h"

namespace grade {
namespace {

// The rest of a line that starts like this; empty if it starts otherwise.
std::string behind(const std::string& line, const std::string& start) {
  return line.starts_with(start) ? line.substr(start.size()) : "";
}

}  // namespace

Task task(const Exercise& exercise) {
  Task task;
  std::istringstream file(read_whole(exercise.folder / "task.md").value_or(""));
  for (std::string line; std::getline(file, line) && !line.empty();) {
    task.title += behind(line, "# ");
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
    std::snprintf(line, sizeof line, "%-4s %-36s %-9s level %s %3s min  %s\n",
                  is_done(exercise) ? "done" : "", exercise.name.c_str(), about.kind.c_str(),
                  about.difficulty.c_str(), about.minutes.c_str(), about.title.c_str());
    text += line;
  }
  return text;
}

}  // namespace grade
