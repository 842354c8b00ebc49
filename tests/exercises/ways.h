// SPDX-License-Identifier: MIT-0
/// @file
/// Submissions of ours, which need no cage: many of them in one driver or one library, which
/// ways.mjs writes.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

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
  /// @param diagnoses  whether the mistake is looked for, which takes longest of all
  grade::Report grade(const std::filesystem::path& header, std::uint64_t seed,
                      const cage::Limits& limits = {}, const std::string& only = "",
                      bool diagnoses = true) const;

 private:
  grade::Exercise exercise_;
  cage::File file_;
};

/// A library of the same submissions, which are called in this process: quick, but one that crashes
/// or never comes back takes us with it, and what it remembers it knows the next time, too.
class Library {
 public:
  /// @throws std::runtime_error if there is no such library
  Library(grade::Exercise exercise, const std::filesystem::path& library);

  /// Judges the submission that the library has under the header's path, and says of no mistake
  /// which it is.
  /// @param only  the one test to run, by its name; all, if empty
  grade::Report grade(const std::filesystem::path& header, std::uint64_t seed,
                      const std::string& only = "") const;

 private:
  using Way = void (*)(harness::Call& call);

  grade::Exercise exercise_;
  Way (*way_of_)(const char* header) = nullptr;
};

}  // namespace ways
