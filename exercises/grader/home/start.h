// SPDX-License-Identifier: MIT-0
/// @file
/// Begins an exercise.
#pragma once
#include <filesystem>

#include "exercise.h"

namespace grade {

/// Puts the starter into a folder, under the name that the grader knows it by, and beside it what
/// editors want to know, unless that stands in this folder or in one above. Nothing is overwritten.
/// @param folder  made if it is not there; empty: the current one
/// @returns the exit code: 0; 2 if there is such a file
int start(const Exercise& exercise, const std::filesystem::path& folder);

}  // namespace grade
