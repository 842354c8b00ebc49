// SPDX-License-Identifier: MIT-0
/// @file
/// All that a student is told about an assignment, on one page.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "course/marks.h"
#include "grade_submission.h"

namespace grade {

/// One exercise of the student: its mark, the report, and the folder of the report.
struct PageExercise {
  Mark mark;
  Report report;
  std::filesystem::path folder;
};

/// The page's head.
struct PageHead {
  std::string course, assignment, student;
  bool show_seed = true;
};

/// A page that needs nothing but itself, with the pictures in it, and the words of feedback.md. All
/// text that may be a student's is escaped.
std::string student_page(const PageHead& head, const std::vector<PageExercise>& exercises);

/// The name of a student's file: the key, with what is no letter, digit or one of `@._+-` spelled
/// out, so that it is a name anywhere and no two become the same.
std::string page_name(const std::string& key);

}  // namespace grade
