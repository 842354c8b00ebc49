// SPDX-License-Identifier: MIT-0
/// @file
/// A program and its descendants: they are found, killed and reaped, whatever they fork.
#pragma once
#include <sys/types.h>

#include <vector>

namespace cage {

/// From now on the orphans among our descendants become our children, so that none can hide: this
/// process is a child subreaper.
void become_subreaper();

/// The children of this process, also the zombies: dead, and not yet reaped.
std::vector<pid_t> children();

/// The end of a program, and what it and its descendants used.
struct Reaped {
  int status = 0;           ///< of the program itself, as wait gives it
  double processor = 0;     ///< of all together [s]
  long peak_kilobytes = 0;  ///< of the largest
};

/// Kills (SIGKILL) the program and every child of ours that is not among `others`, and reaps them
/// until none is left; so nothing else may start children in between.
Reaped kill_and_reap(pid_t program, const std::vector<pid_t>& others);

}  // namespace cage
