// SPDX-License-Identifier: MIT-0
/// @file
/// The students of a class, and what they handed in.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "exercise.h"

namespace grade {

/// A folder of submissions.
struct Student {
  std::string name;  ///< of the folder: any bytes
  std::filesystem::path folder;
};

struct ClassList {
  std::vector<Student> students;  ///< by name
  std::vector<std::string>
      ignored;  ///< names of what is no student's: files, links, hidden folders
};

/// The folders in this one. Links are not followed.
/// @throws std::filesystem::filesystem_error  it cannot be read
ClassList read_students(const std::filesystem::path& submissions);

/// Returns whether there is a file, or anything else, of the right name: in the chapter's folder
/// or, as Moodle hands files out, in the student's own.
bool has(const Student& student, const Exercise& exercise);

/// The exercises for which somebody has a file, or anything else, of the right name.
std::vector<Exercise> handed_in(const std::vector<Student>& students,
                                const std::vector<Exercise>& exercises);

/// Whether a file is called as a header, in small letters or in capitals: so that its student is
/// told how it should be called.
bool is_header(const std::string& name);

/// Headers in the place of an exercise that there is not: `ada/2-euler/orbit-drfit.h`, or
/// `ada/orbit-drfit.h`. Of many of one student come the first few, and how many more there are.
std::vector<std::string> without_exercise(const std::vector<Student>& students,
                                          const std::vector<Exercise>& exercises);

}  // namespace grade
