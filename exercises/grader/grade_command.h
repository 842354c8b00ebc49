// SPDX-License-Identifier: MIT-0
#pragma once
#include "command_line.h"

namespace grade {

/// Grades one submission, keeps the report if there is a folder for it, and prints it.
/// @returns the exit code
int grade_and_report(Command command);

/// Runs the student's own main and prints what it printed.
/// @returns the exit code: 0; 1 if it did not run, or not to a good end
int run_and_print(const Command& command);

}  // namespace grade
