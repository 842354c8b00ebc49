// SPDX-License-Identifier: MIT-0
/// @file
/// The limits of time that the grader of a class hands to the one of a submission, and what follows
/// from them.
#pragma once
#include <string>
#include <string_view>

#include "grade_submission.h"

namespace grade {

/// The times of both limits; the rest is never calibrated.
std::string write_limits(const Request& request);

/// @returns whether it was such a text
bool read_limits(std::string_view text, Request& request);

/// The time that all drivers of a run may take together, on the clock [s]: what one of them may,
/// for each of the tests.
double longest_run(const Request& request);

/// The time that a grading can take [s]: the compiler, and all runs, each to its limit; as much
/// again for what is ours.
double longest_grading(const Request& request);

}  // namespace grade
