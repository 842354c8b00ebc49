// SPDX-License-Identifier: MIT-0
/// @file
/// How a module ends that is not as it should be, as the page tells it.
#pragma once

namespace page {

/// judging.js has the same numbers.
enum class Ending {
  trapped = -1,   ///< a check of the compiler's
  outside = -2,   ///< of its memory
  too_deep = -3,  ///< it called itself without end
  threw = -4,
  left = -5,           ///< by exit(0)
  left_by_error = -6,  ///< by exit(1), abort() or an assertion
  printed_too_much = -7,
  no_memory = -8,
};

/// Leaves it in the session, in words.
void note_ending(Ending ending);

}  // namespace page
