// SPDX-License-Identifier: MIT-0
#pragma once
#include <string>

#include "grade_submission.h"

namespace grade {

/// The report for a terminal of 80 columns. What may come from a submission is escaped.
/// @param colour  with colours, which say nothing that the words don't
std::string terminal(const Report& report, bool colour);

}  // namespace grade
