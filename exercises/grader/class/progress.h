// SPDX-License-Identifier: MIT-0
/// @file
/// The progress of a class's grading.
#pragma once
#include <chrono>
#include <cstddef>
#include <string>

#include "class/job.h"

namespace grade {

/// On a terminal one line with a bar, renewed; elsewhere a line for each submission.
class Progress {
 public:
  Progress(std::size_t all, bool on_terminal);

  /// One more is done.
  void done(const Job& job, const Report& report);

 private:
  std::size_t all_, done_ = 0;
  bool on_terminal_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace grade
