// SPDX-License-Identifier: MIT-0
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace grade {

/// The command line as it was typed, before it is checked.
struct Options {
  std::string exercise, file, out, seed, seed_file, shard, limits, submissions, run, assigned;
  std::string course, round;
  std::string sandbox = "bubblewrap", exit_status = "grader";
  std::vector<std::string> emits, exercises;
  std::string jobs;  ///< empty: as many as there are processors
  bool list = false, version = false, all = false, unchecked = false;
};

/// Nothing if only the help was asked for, which is printed then.
/// @throws Usage
std::optional<Options> read_options(int argc, char** argv);

}  // namespace grade
