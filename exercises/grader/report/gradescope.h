// SPDX-License-Identifier: MIT-0
#pragma once
#include <string>
#include <vector>

#include "grade_submission.h"

namespace grade {

/// results.json, as Gradescope's autograders write it. Made of what report.json holds, no more.
/// @see https://gradescope-autograders.readthedocs.io/en/latest/specs/
std::string gradescope(const Report& report);

/// One of the reports on several exercises, with the sum of their points. Of each there is a first
/// entry without points that students see at once: whether it was there, and compiles.
std::string gradescope(const std::vector<Report>& reports);

}  // namespace grade
