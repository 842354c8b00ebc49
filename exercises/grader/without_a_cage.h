// SPDX-License-Identifier: MIT-0
/// @file
/// Grading without a cage, and when that is refused.
#pragma once
#include "grade_submission.h"

namespace grade {

/// Lets what is graded run like any other program here: of this user, or of another one if this is
/// root over all users.
/// @throws Usage  it could then read the file that the seed came from
void do_without_a_cage(Request& request);

/// The same, only where no cage can be had; then says so.
void do_without_a_cage_that_cannot_be_had(Request& request);

}  // namespace grade
