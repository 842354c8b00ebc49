// SPDX-License-Identifier: MIT-0
#pragma once
#include <string>

#include "grade_submission.h"
#include "report/words.h"

namespace grade {

/// The report for a terminal of 80 columns, its numbers to six digits; what is expected and what
/// came, to as many as tell them apart. What may come from a submission is escaped.
/// @param colour  with colours, which say nothing that the words don't
/// @param all  tests that failed, each with all that was found; else only the first, and of the
/// others a line each
/// @param place  of the grader, for what to run next
std::string terminal(const Report& report, bool colour, bool all = false, const Place& place = {});

/// The first test that failed and the verdict below it, so that both stay in sight.
std::string on_one_screen(const Report& report, bool colour);

}  // namespace grade
