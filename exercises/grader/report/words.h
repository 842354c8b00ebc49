// SPDX-License-Identifier: MIT-0
/// @file
/// A report in words, for whatever shows it.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "grade_submission.h"

namespace grade {

/// The meaning of a verdict, in one sentence to the student.
std::string_view sentence(Verdict verdict);

/// Returns whether there is a grade: not if the grader failed.
bool is_graded(const Report& report);

/// `PARTIAL, 4 of 10 points`, or that there is no grade
std::string headline(const Report& report);

/// `held`, `did not hold` or `not run`; `ended here` of the test in which the program did
/// @param test  of this report
std::string_view outcome(const Report& report, const TestResult& test);

/// Returns whether it ran and did not hold.
bool has_failed(const TestResult& test);

/// Points earned in this test.
int earned(const TestResult& test);

/// Returns whether an error is a number with what it counts, and no sentence.
bool is_size(const std::string& error);

/// One thing that was found, with its label; labels are at most nine letters long.
struct Line {
  std::string label, text;
};
std::vector<Line> lines(const Finding& finding);

/// Returns whether its picture can be drawn.
bool has_plot(const Finding& finding);

/// A name as one word for a shell, and no option; empty if it has letters that nobody could see.
std::string shell_word(const std::string& file);

/// The places of the grader and the submission, as a shell finds them.
struct Place {
  std::string grade = "build/exercises/grade";
  std::string file = {};  ///< empty: a header with the exercise's own name
};

/// The commands to run next, for a shell. None of them overwrites a file.
/// @param seen  from where the student called the grader, unless that is the folder in which the
///              exercises were unpacked. A name with letters that nobody could see is replaced by
///              the one that it has there.
std::vector<std::string> next_commands(const Report& report, const Place& seen = {});

/// The sentence that says with which seed, grader and sandbox it was graded.
std::string provenance(const Report& report);

/// `bubblewrap` or `none`
std::string_view name(cage::Sandbox sandbox);

}  // namespace grade
