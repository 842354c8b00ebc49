// SPDX-License-Identifier: MIT-0
/// @file
/// The right ways to do an exercise, for whoever has found one.
#pragma once
#include <string>

#include "exercise.h"

namespace grade {

/// Shows them, if this student has had full marks.
/// @returns the exit code: 0; 2 if not, or if they are not here
int show_right_ways(const Exercise& exercise);

/// All of them, read from the exercise's folder, as nobody comes upon them by chance. They are no
/// secret: this program can read them.
std::string sealed_right_ways(const Exercise& exercise);

}  // namespace grade
