// SPDX-License-Identifier: MIT-0
#pragma once
#include "command_line.h"
#include "report/words.h"

namespace grade {

/// A report, and from where the grader was called for it.
struct Graded {
  Report report;
  Place place;
  bool of_a_class = false;
};

/// Grades one submission, keeps the report if there is a folder for it, and remembers what is done.
Graded grade_one(Command command);

/// Returns whether what is printed is on a terminal, and nobody wants it without colours.
bool in_colour();

/// On a terminal with colours, unless somebody wants none.
void print(const Graded& graded, bool all);

/// Grades one submission, keeps the report if there is a folder for it, and prints it.
/// @returns the exit code
int grade_and_report(const Command& command);

/// Runs the student's own main and prints what it printed.
/// @returns the exit code: 0; 1 if it did not run, or not to a good end
int run_and_print(const Command& command);

}  // namespace grade
