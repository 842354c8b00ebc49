// SPDX-License-Identifier: MIT-0
/// @file
/// What an exercise's tests ask, against what its harness.h says may be asked.
#pragma once
#include "grade_submission.h"
#include "seeds.h"

namespace ways {

/// Whether each bound and each special value that the exercise's harness.h names was asked, and
/// each power of ten between, and nothing beyond. What is drawn is drawn by one seed and not by
/// another, so a second and a third are tried where something is missing.
bool asks_all(const Grade& grade, const grade::Exercise& exercise);

}  // namespace ways
