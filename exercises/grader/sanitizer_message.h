// SPDX-License-Identifier: MIT-0
/// @file
/// The messages of the checkers of memory and of undefined behaviour, in the words of the feedback.
#pragma once
#include <string>

namespace grade {

/// The sentence for what they printed about a header; empty if it is no report of theirs.
std::string sanitizer_message(const std::string& printed, const std::string& header);

/// Returns what the program printed, without what they say of the cage, in which they miss
/// something.
std::string without_warnings(const std::string& printed);

/// Returns whether it stopped a program that held too much memory. Takes what it printed of that
/// away.
bool ran_out_of_memory(std::string& printed);

}  // namespace grade
