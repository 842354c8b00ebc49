// SPDX-License-Identifier: MIT-0
/// @file
/// The files that this grader needs beside itself.
#pragma once
#include <string>
#include <vector>

namespace grade {

/// The content of `installed.txt`.
struct Installed {
  std::string exercises;                   ///< folder with a folder for each chapter
  std::string kit;                         ///< folder with what goes into the cage
  std::vector<std::string> student_flags;  ///< for the compiler
  std::vector<std::string> checked_flags;  ///< the same, with a checker of memory
};

/// Read once, from beside the program, or from the build that it is part of.
/// @throws std::runtime_error if it is in neither place, or is no file
const Installed& installed();

}  // namespace grade
