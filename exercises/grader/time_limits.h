// SPDX-License-Identifier: MIT-0
/// @file
/// Calibrated limits, handed from the grader of a class to the one of a submission.
#pragma once
#include <string>
#include <string_view>

#include "grade_submission.h"

namespace grade {

/// The times of both limits; the rest is never calibrated.
std::string write_limits(const Request& request);

/// @returns whether it was such a text
bool read_limits(std::string_view text, Request& request);

}  // namespace grade
