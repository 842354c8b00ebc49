// SPDX-License-Identifier: MIT-0
/// @file
/// The one vocabulary in which a submission is judged.
#pragma once
#include <optional>
#include <string_view>

namespace grade {

enum class Verdict {
  accepted,        ///< full marks
  partial,         ///< some tests held, some did not
  wrong_answer,    ///< it ran to the end, and no test held
  compile_error,   ///< the compiler refused it
  compile_limit,   ///< the compiler ran out of time, memory or output
  link_error,      ///< it compiles, and yet no program comes of it
  rejected,        ///< not even read: not one small text file, or it defines main
  runtime_error,   ///< it crashed, threw, or asked the system for something forbidden
  time_limit,      ///< it did not come back in time
  memory_limit,    ///< it wanted more memory than it may have
  output_limit,    ///< it printed without end
  incomplete,      ///< it ended early without an error, as by calling exit
  protocol_error,  ///< what came back was not an answer
  grader_error,    ///< ours, never the student's
};

/// Returns whether the code ran to its end, so that the tests have a say.
bool is_judged(Verdict verdict);

/// The verdict's name in a report: `ACCEPTED`, `WRONG_ANSWER` and so on.
std::string_view name(Verdict verdict);

/// The verdict of that name; nothing if there is none.
std::optional<Verdict> verdict_named(std::string_view name);

}  // namespace grade
