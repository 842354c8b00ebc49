// SPDX-License-Identifier: MIT-0
/// @file
/// An assignment of a course, graded as a class.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "course/course.h"
#include "course/roster.h"

namespace grade {

/// Grades it, and writes its marks and tables into its folder of the results.
/// @param roster  nothing: whoever has a folder takes part
/// @param named  it was asked for by name, so that it is an error if nothing is there
/// @returns the exit code
int grade_round(const Course& course, const Assignment& assignment,
                const std::optional<std::vector<Member>>& roster, std::size_t jobs, bool named);

/// The file of its marks.
std::filesystem::path marks_file(const Course& course, const Assignment& assignment);

}  // namespace grade
