// SPDX-License-Identifier: MIT-0
/// @file
/// Submissions of ours, which need no cage: many of them in one driver, which ways.mjs writes.
#pragma once
#include <cstdint>
#include <filesystem>

#include "grade_submission.h"

namespace ways {

/// A driver that holds submissions of one exercise.
class Driver {
 public:
  /// @throws std::runtime_error if there is no such file
  Driver(grade::Exercise exercise, const std::filesystem::path& driver);

  /// Judges the submission that the driver has under the header's path. It runs in a process of its
  /// own for each test, with the limits of a submission.
  /// @param only  the one test to run, by its name; all, if empty
  grade::Report grade(const std::filesystem::path& header, std::uint64_t seed,
                      const cage::Limits& limits = {}, const std::string& only = "") const;

 private:
  grade::Exercise exercise_;
  cage::File file_;
};

}  // namespace ways
