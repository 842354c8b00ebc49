// SPDX-License-Identifier: MIT-0
#pragma once
#include <optional>
#include <vector>

#include "class/job.h"
#include "grade_submission.h"

namespace grade {

/// Grades each of them in a process of its own, and shows how far it has come.
/// @returns why none of them was graded: the grader failed at an exercise's own solution
std::optional<Obstacle> grade_all(const std::vector<Job>& jobs, const Class& work);

}  // namespace grade
