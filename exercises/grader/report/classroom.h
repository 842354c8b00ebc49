// SPDX-License-Identifier: MIT-0
#pragma once
#include <string>
#include <vector>

#include "grade_submission.h"

namespace grade {

/// What a step of a workflow says of its tests, as GitHub Classroom's graders do and as its
/// reporter reads it from an environment variable: short enough for one, whatever the reports hold.
/// @see https://github.com/classroom-resources/autograding-grading-reporter
std::string classroom(const std::vector<Report>& reports);

}  // namespace grade
