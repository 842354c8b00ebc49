// SPDX-License-Identifier: MIT-0
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace grade {

enum class What {
  nothing,
  one,
  whole_class,
  course,
  collect,
  hand_back,
  gradescope,
  classroom,
  version,
  watch,
  start,
  list,
  hint,
  run,
  play,
  level,
  ways,
  seal,
  check
};

/// The command line as it was typed, before it is checked.
struct Options {
  std::optional<What> word;                ///< `start` and the like
  std::string said, first, second, third;  ///< it, and what stands behind it
  std::string exercise, file, out, seed, seed_file, shard, limits, submissions, assigned;
  std::string round, until, worksheet, column, course;
  std::string sandbox = "bubblewrap", exit_status = "grader";
  std::vector<std::string> emits, exercises;
  std::string jobs;  ///< empty: as many as there are processors
  bool version = false, all = false, unchecked = false;
};

/// Nothing if only the help was asked for, which is printed then.
/// @throws Usage
std::optional<Options> read_options(int argc, char** argv);

}  // namespace grade
