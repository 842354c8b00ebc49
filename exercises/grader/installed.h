// SPDX-License-Identifier: MIT-0
/// @file
/// The files that this grader needs beside itself.
#pragma once
#include <string>
#include <vector>

namespace grade {

/// The content of `installed.txt`, which is written where the kit is made.
struct Installed {
  std::string exercises;  ///< folder with a folder for each chapter
  std::string kit;        ///< folder with what goes into the cage
  std::string compiler;   ///< that the kit was made with, and submissions are compiled with
  std::vector<std::string> student_flags;      ///< for the compiler
  std::vector<std::string> checked_flags;      ///< the same, with a checker of memory
  std::vector<std::string> shown_to_compiler;  ///< folders that it needs in its cage
  std::vector<std::string> shown_to_checked;   ///< libraries that a checked program needs in its
};

/// Read once, from beside the program, or from the build that it is part of.
/// @throws std::runtime_error if it is in neither place, or is no file
const Installed& installed();

}  // namespace grade
