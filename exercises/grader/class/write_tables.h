// SPDX-License-Identifier: MIT-0
/// @file
/// What a class comes to.
#pragma once
#include <string>

#include "class/results.h"

namespace grade {

/// `1 student`, `2 students`
std::string count(std::size_t number, const std::string& thing);

/// Says on stderr why not.
/// @returns the code
int refuse(int code, const std::string& why);

/// Graded, or that the grader failed somewhere.
int exit_code(const std::vector<Report>& reports);

/// Writes the tables and the page, unless they would mix graders.
/// @returns the exit code
int conclude(const Roll& roll, const std::vector<Exercise>& exercises, const std::vector<Job>& jobs,
             const Class& work);

}  // namespace grade
