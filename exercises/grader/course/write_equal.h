// SPDX-License-Identifier: MIT-0
#pragma once
#include <vector>

#include "class/class.h"
#include "class/job.h"
#include "course/roster.h"

namespace grade {

/// Writes equal.csv, and says how many places there are to look at. Where numbers are equal, the
/// exercise's starter is graded, too.
/// @param jobs  of all folders with all exercises, folder by folder in the students' order
void write_equal(const Class& work, const Participants& students, const std::vector<Job>& jobs);

}  // namespace grade
