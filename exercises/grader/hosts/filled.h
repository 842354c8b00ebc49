// SPDX-License-Identifier: MIT-0
/// @file
/// A system's table, filled in with marks.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "course/marks.h"

namespace grade {

struct Filled {
  std::string text;                  ///< of the table
  std::size_t students = 0;          ///< whose mark stands in it now
  std::vector<std::string> nowhere;  ///< have a mark and no row
  std::vector<std::string> no_mark;  ///< have a row and no whole mark
};

/// The sum of a student's points; nothing where a mark is missing.
std::optional<int> sum_of(const StudentMarks& student);

/// What the student is told in a line: points by exercise, and what being late took.
std::string comment_on(const StudentMarks& student);

/// Moodle's worksheet: the grade, and a comment where it has a column for these. A student is found
/// by the number in the folder's name; where it has none, by address or by a name that only one
/// has.
/// @throws Usage  it is none, or another assignment's, or that is out of another sum than the round
Filled filled_worksheet(const Marks& marks, const std::filesystem::path& file);

/// Canvas's gradebook: one column. A student is found by `ID`, or else by `SIS Login ID`, `SIS User
/// ID` or the name.
/// @throws Usage  it is none, or lacks the column, or that is out of another sum than the round
Filled filled_gradebook(const Marks& marks, const std::filesystem::path& file,
                        const std::string& column);

}  // namespace grade
