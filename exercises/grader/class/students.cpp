// SPDX-License-Identifier: MIT-0
#include "class/students.h"

#include <algorithm>
#include <system_error>

namespace grade {
namespace {

bool is_folder(const std::filesystem::directory_entry& entry) {
  std::error_code none;
  return entry.symlink_status(none).type() == std::filesystem::file_type::directory;
}

bool has(const Student& student, const Exercise& exercise) {
  std::error_code none;
  const auto path = student.folder / exercise.chapter() / exercise.header();
  return std::filesystem::exists(std::filesystem::symlink_status(path, none));
}

}  // namespace

Roll call_roll(const std::filesystem::path& submissions) {
  Roll roll;
  for (const auto& entry : std::filesystem::directory_iterator(submissions)) {
    const std::string name = entry.path().filename().string();
    if (is_folder(entry) && !name.starts_with('.')) {
      roll.students.push_back({name, entry.path()});
    } else {
      roll.ignored.push_back(name);
    }
  }
  std::ranges::sort(roll.students, {}, &Student::name);
  std::ranges::sort(roll.ignored);
  return roll;
}

std::vector<Exercise> handed_in(const std::vector<Student>& students,
                                const std::vector<Exercise>& exercises) {
  std::vector<Exercise> found;
  for (const Exercise& exercise : exercises) {
    const bool any =
        std::ranges::any_of(students, [&](const Student& s) { return has(s, exercise); });
    if (any) found.push_back(exercise);
  }
  return found;
}

std::vector<std::string> without_exercise(const std::vector<Student>& students,
                                          const std::vector<Exercise>& exercises) {
  const auto known = [&](const std::string& name) {
    return std::ranges::any_of(exercises, [&](const Exercise& e) { return e.name + ".h" == name; });
  };
  std::vector<std::string> found;
  for (const Student& student : students) {
    std::error_code unreadable;  // which the grading itself will say
    for (const auto& chapter : std::filesystem::directory_iterator(student.folder, unreadable)) {
      if (!is_folder(chapter)) continue;
      for (const auto& file : std::filesystem::directory_iterator(chapter.path(), unreadable)) {
        const std::string name =
            chapter.path().filename().string() + "/" + file.path().filename().string();
        if (name.ends_with(".h") && !known(name)) found.push_back(student.name + "/" + name);
      }
    }
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace grade
