// SPDX-License-Identifier: MIT-0
#pragma once
#include <string>

#include "grade_submission.h"

namespace grade {

/// junit.xml in the shape that Catch2 writes, but with a failure for each test and not for each
/// comparison. Made of what report.json holds, no more.
///
/// The first case stands for the submission as a whole: an error if it was not taken, not compiled
/// or did not run to its end.
std::string junit(const Report& report);

}  // namespace grade
