// SPDX-License-Identifier: MIT-0
/// @file
/// Runs a student's own main.
#pragma once
#include <filesystem>
#include <string>

#include "cage/cage.h"

namespace grade {

/// The prints of a program that was run for them, or why there are none.
struct Ran {
  std::string out;  ///< what it printed, of much of it the beginning and the end
  std::string err;
  std::string why;          ///< why it did not run or did not end by itself; empty if all was well
  bool unreadable = false;  ///< the header, that is
};

/// Compiles a header with the main that it has where GRADING is not defined, under the checkers of
/// memory and of undefined behaviour, and runs it in the cage.
Ran run_own(const std::filesystem::path& file, cage::Sandbox sandbox);

}  // namespace grade
