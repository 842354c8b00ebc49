// SPDX-License-Identifier: MIT-0
/// @file
/// The exercises that a student has done: those for which this program, called for one submission,
/// gave full marks. Their names stand in the state `done.txt`.
#pragma once
#include "exercise.h"

namespace grade {

/// Returns whether it has ever had full marks here.
/// @throws NotOwn  `done.txt` is none of ours
bool is_done(const Exercise& exercise);

/// Remembers that it has, for the first time. Where the file can't be written, nothing is
/// remembered.
void note_done(const Exercise& exercise);

}  // namespace grade
