// SPDX-License-Identifier: MIT-0
/// @file
/// Grades what is saved.
#pragma once
#include "command_line.h"

namespace grade {

/// Grades the answer of the current folder that was saved last, and then each that is saved, until
/// the program is stopped. Where nobody sees a terminal, it grades that one and ends.
/// @returns the exit code: that of the one; 2 if there is no answer and no terminal
int watch(const Command& command);

}  // namespace grade
