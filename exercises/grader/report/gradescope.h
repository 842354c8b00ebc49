// SPDX-License-Identifier: MIT-0
#pragma once
#include <string>

#include "grade_submission.h"

namespace grade {

/// results.json, as Gradescope's autograders write it. Made of what report.json holds, no more.
/// @see https://gradescope-autograders.readthedocs.io/en/latest/specs/
std::string gradescope(const Report& report);

}  // namespace grade
