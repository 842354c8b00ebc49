// SPDX-License-Identifier: MIT-0
/// @file
/// A class graded: its tables and its page.
#pragma once
#include <vector>

#include "class/results.h"

namespace grade {

/// Writes the tables and the page, unless they would mix graders.
/// @returns the exit code
int write_tables(const ClassList& list, const std::vector<Exercise>& exercises,
                 const std::vector<Job>& jobs, const Class& work);

}  // namespace grade
