// SPDX-License-Identifier: MIT-0
/// @file
/// The findings of a checker of memory in a second run, which no test judges.
#pragma once
#include <string>

#include "grade_submission.h"

namespace grade {

/// Compiles a submission with AddressSanitizer, puts the same questions to it once more, and reads
/// what the checker printed. Nothing that happens there changes the verdict.
/// @param text  the submission, which compiles
/// @param harness  the exercise's harness.h
/// @return  a sentence for the student; empty if nothing was found or the checker could not run
std::string misused_memory(const Request& request, const cage::Kit& kit, const std::string& text,
                           const std::string& harness);

}  // namespace grade
