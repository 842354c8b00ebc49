// SPDX-License-Identifier: MIT-0
/// @file
/// Failed assertions of the standard library, in a student's words.
#pragma once
#include <string>

namespace grade {

/// The mistake for which an assertion of the library, or an exception that nobody catches, ended
/// the program; it goes behind "Your code".
/// @param printed  by the program, to stderr
/// @returns  empty if neither stopped it
std::string failed_assertion(const std::string& printed);

}  // namespace grade
