// SPDX-License-Identifier: MIT-0
/// @file
/// A report in words, for whatever shows it.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "grade_submission.h"

namespace grade {

/// What a verdict means, in one sentence to the student.
std::string_view sentence(Verdict verdict);

/// Whether there is a grade: not if the grader failed.
bool is_graded(const Report& report);

/// `PARTIAL, 4 of 10 points`, or that there is no grade
std::string headline(const Report& report);

/// `held`, `did not hold` or `not run`
std::string_view outcome(const TestResult& test);

/// Points earned in this test.
int earned(const TestResult& test);

/// One thing that was found, with its label; labels are at most nine letters long.
struct Line {
  std::string label, text;
};
std::vector<Line> lines(const Finding& finding);

/// Whether its picture can be drawn.
bool has_plot(const Finding& finding);

/// What to run next, as commands for a shell.
/// @param file  the submission as the student calls it; if that is no plain name of a header, the
///              exercise's own takes its place
std::vector<std::string> next_commands(const Report& report, const std::string& file);

/// With which seed, grader and sandbox it was graded, as a sentence.
std::string provenance(const Report& report);

/// `bubblewrap` or `none`
std::string_view name(cage::Sandbox sandbox);

}  // namespace grade
