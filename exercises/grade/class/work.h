// SPDX-License-Identifier: MIT-0
#pragma once
#include <vector>

#include "class/job.h"

namespace grade {

/// Grades each of them in a process of its own, and shows how far it has come.
void grade_all(const std::vector<Job>& jobs, const Class& work);

}  // namespace grade
