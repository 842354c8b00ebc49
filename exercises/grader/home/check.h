// SPDX-License-Identifier: MIT-0
#pragma once

namespace grade {

/// Tries all that grading needs on this machine, a line each, with the cure where it fails.
/// @returns the exit code: 0 if code can be graded here, if only without a cage; 1 if not
int check_machine();

}  // namespace grade
