// SPDX-License-Identifier: MIT-0
/// @file
/// What the standard library's assertions say, in a student's words.
#pragma once
#include <string>

namespace grade {

/// What code has done that an assertion of the library, or an exception that nobody catches,
/// stopped: it goes behind "Your code".
/// @param printed  by the program, to stderr
/// @returns  empty if neither stopped it
std::string failed_assertion(const std::string& printed);

}  // namespace grade
