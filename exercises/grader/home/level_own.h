// SPDX-License-Identifier: MIT-0
/// @file
/// The level, kept running by a student's headers.
#pragma once
#include "command_line.h"

namespace grade {

/// Plays the level for an hour with the headers of a folder, and says of each part whether a
/// producer would be content. A part whose header is not there is not counted.
/// @returns the exit code: 0 if it was played, or by --exit-status verdict only if all is kept
int play_level(const Command& command);

/// Lists the exercises whose headers keep it.
void list_level();

}  // namespace grade
