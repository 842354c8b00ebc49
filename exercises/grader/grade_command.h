// SPDX-License-Identifier: MIT-0
#pragma once
#include "command_line.h"

namespace grade {

/// Grades one submission, keeps the report if there is a folder for it, and prints it.
/// @returns the exit code
int grade_and_report(const Command& command);

}  // namespace grade
