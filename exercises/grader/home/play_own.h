// SPDX-License-Identifier: MIT-0
/// @file
/// A student's code moves.
#pragma once
#include "command_line.h"

namespace grade {

/// Writes a page beside the header, with its code at work in the exercise's scene and, if a test
/// fails, the run in which it did.
/// @returns the exit code: 0; 1 if it does not compile, or came to no good end; 2 if the page would
///          replace a file that is none of ours
int play_own(const Command& command);

}  // namespace grade
