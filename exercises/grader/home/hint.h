// SPDX-License-Identifier: MIT-0
/// @file
/// The hints of an exercise, one after the other.
#pragma once
#include <string>
#include <vector>

#include "exercise.h"

namespace grade {

/// Those of its task.md, their formulas in plain letters.
std::vector<std::string> hints(const Exercise& exercise);

/// Shows the first that was not shown yet; when all were, all of them.
/// @returns the exit code
int show_hint(const Exercise& exercise);

}  // namespace grade
