// SPDX-License-Identifier: MIT-0
/// @file
/// The end of a student's program that is not as it should be, in words, left in the session. Of
/// several the first counts.
#pragma once
#include <cstddef>
#include <string>

#include "verdict.h"

namespace judge {

/// @param printed  by the program, to stderr
void note(grade::Verdict verdict, const std::string& why, const std::string& printed = "");

/// It wrote or read outside of its memory, or called itself without end.
void note_crash(const std::string& printed = "");

/// It was stopped by a check that the compiler had put there.
void note_trap(const std::string& printed = "");

/// It threw.
/// @param printed  what it threw, in words
void note_exception(const std::string& printed = "");

/// It ended by itself.
void note_exit_code(int code, const std::string& printed = "");

/// It ended without an error, and owed an answer.
void note_incomplete();

/// @param longest  that it had, in words
void note_too_long(const std::string& longest);

/// @param most  that it may print, in words
void note_too_much(const std::string& most);

/// An answer made no sense.
void note_protocol_error();

/// An answer has another number of numbers than it should have.
void note_other_count(double came, std::size_t wanted);

}  // namespace judge
