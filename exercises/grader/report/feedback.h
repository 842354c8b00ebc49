// SPDX-License-Identifier: MIT-0
#pragma once
#include <string>

#include "grade_submission.h"
#include "report/words.h"

namespace grade {

/// The report for the student, in Markdown. What may come from a submission is escaped.
/// @param place  for what to run next; a class leaves it out, since its students run it elsewhere
std::string feedback(const Report& report, const Place& place = {});

}  // namespace grade
