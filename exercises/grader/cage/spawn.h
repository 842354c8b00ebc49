// SPDX-License-Identifier: MIT-0
/// @file
/// Starts a program that inherits nothing but what it is given.
#pragma once
#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

#include "process.h"

namespace cage {

struct Pipe {
  File read, write;
};

/// Both ends close on exec and lie above the numbers that a program is given.
Pipe open_pipe();

/// Reads and writes on it come back at once.
void set_nonblocking(const File& file);

/// Starts a program (posix_spawn) in a session of its own, with default signals and a fixed
/// environment.
///
/// @param files  our descriptors, and their numbers (0 to 19) in the program; all others are closed
/// @returns its number, or 0 with errno set
pid_t spawn(const std::vector<std::string>& command, const std::vector<std::pair<int, int>>& files);

}  // namespace cage
