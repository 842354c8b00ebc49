// SPDX-License-Identifier: MIT-0
#include "class/students.h"

#include <algorithm>
#include <cstddef>
#include <system_error>

#include "hosts/store.h"

namespace grade {
namespace {

bool is_folder(const std::filesystem::directory_entry& entry) {
  std::error_code none;
  return entry.symlink_status(none).type() == std::filesystem::file_type::directory;
}

// Adds those of a folder's headers that are no exercise's.
void add_unknown(std::vector<std::string>& found, const Student& student,
                 const std::filesystem::path& chapter, const std::vector<Exercise>& exercises) {
  const auto known = [&](const std::string& header) {
    return std::ranges::any_of(exercises, [&](const Exercise& e) {
      return e.header() == header && (chapter.empty() || e.chapter() == chapter);
    });
  };
  std::error_code unreadable;  // which the grading itself will say
  for (const auto& file :
       std::filesystem::directory_iterator(student.folder / chapter, unreadable)) {
    const std::string header = file.path().filename().string();
    if (is_header(header) && !known(header))
      found.push_back((std::filesystem::path(student.name) / chapter / header).string());
  }
}

std::vector<std::string> unknown(const Student& student, const std::vector<Exercise>& exercises) {
  std::vector<std::string> found;
  add_unknown(found, student, "", exercises);
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator(student.folder, unreadable)) {
    if (is_folder(entry)) add_unknown(found, student, entry.path().filename(), exercises);
  }
  std::ranges::sort(found);
  return found;
}

// The first few of a student's names, so that one student's many hide nobody's one.
std::vector<std::string> first_few(std::vector<std::string> names, const std::string& student) {
  constexpr std::size_t most = 3;
  if (names.size() <= most) return names;
  const std::size_t more = names.size() - most;
  names.resize(most);
  names.push_back(student + ": " + std::to_string(more) + " more");
  return names;
}

}  // namespace

bool is_header(const std::string& name) {
  return name.ends_with(".h") || name.ends_with(".H");
}

bool has(const Student& student, const Exercise& exercise) {
  for (const auto& folder : {student.folder / exercise.chapter(), student.folder}) {
    std::error_code none;
    if (std::filesystem::exists(std::filesystem::symlink_status(folder / exercise.header(), none)))
      return true;
  }
  return false;
}

ClassList read_students(const std::filesystem::path& submissions) {
  ClassList list;
  for (const auto& entry : std::filesystem::directory_iterator(submissions)) {
    const std::string name = entry.path().filename().string();
    if (is_folder(entry) && !name.starts_with('.')) {
      list.students.push_back({name, entry.path()});
    } else if (!is_of_collection(name)) {
      list.ignored.push_back(name);
    }
  }
  std::ranges::sort(list.students, {}, &Student::name);
  std::ranges::sort(list.ignored);
  return list;
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
  std::vector<std::string> found;
  for (const Student& student : students) {
    const std::vector<std::string> some = first_few(unknown(student, exercises), student.name);
    found.insert(found.end(), some.begin(), some.end());
  }
  return found;
}

}  // namespace grade
