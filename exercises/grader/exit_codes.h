// SPDX-License-Identifier: MIT-0
/// @file
/// The exit codes of the grader.
#pragma once
#include <string>
#include <system_error>
#include <vector>

#include "grade_submission.h"

namespace grade {

enum Exit : int {
  graded = 0,
  below_full_score = 1,  ///< only by --exit-status verdict
  did_not_run = 1,       ///< by --run: not compiled, or not to a good end
  bad_input = 2,
  unreadable = 3,
  failed = 42,  ///< and will fail again
  try_again = 75,
};

/// Says on stderr why not.
/// @returns the code
int refuse(int code, const std::string& why);

/// The exit code of one submission.
int exit_code(const Report& report, bool by_verdict);

/// The exit code of a class: graded, or that the grader failed somewhere.
int exit_code(const std::vector<Report>& reports);

/// The exit code of an error: what the caller can mend, what may mend itself, or the rest.
int exit_code(const std::error_code& error);

}  // namespace grade
