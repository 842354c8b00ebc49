// SPDX-License-Identifier: MIT-0
/// @file
/// An assignment of a course, graded as a class.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "course/course.h"
#include "course/grade_course.h"
#include "course/roster.h"

namespace grade {

/// Grades it, and writes its marks and tables into its folder of the results.
/// @param roster  nothing: whoever has a folder takes part
/// @param work  by whose name it was asked for, so that it is an error if nothing is there; of
/// which
///   a part writes neither marks nor tables
/// @returns the exit code
int grade_round(const Course& course, const Assignment& assignment,
                const std::optional<std::vector<Member>>& roster, const CourseWork& work);

/// The file of its marks.
std::filesystem::path marks_file(const Course& course, const Assignment& assignment);

}  // namespace grade
