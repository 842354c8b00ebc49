// SPDX-License-Identifier: MIT-0
#pragma once
#include <string>

#include "grade_submission.h"

namespace grade {

/// The report for the student, in Markdown. What may come from a submission is escaped.
std::string feedback(const Report& report);

}  // namespace grade
