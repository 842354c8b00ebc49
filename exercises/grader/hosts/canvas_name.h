// SPDX-License-Identifier: MIT-0
/// @file
/// Names that Canvas gives to what was handed in.
#pragma once
#include <string>

namespace grade {

/// `lovelaceada_LATE_4711_98765_orbit-drift.h`, taken apart.
struct CanvasName {
  std::string student;  ///< `4711`, as the column ID of the gradebook; `anon_...` without names
  bool late = false;
  std::string file;     ///< `orbit-drift.h`, as the student called it
  std::string why_not;  ///< it is no such name, or could be read in two ways
};

/// Takes a name apart. Behind the student's own name, which may end in digits, come two numbers,
/// and then what the student has written: a name in which more than one pair could be these
/// numbers is not guessed at, since it could make one's file another's.
/// @see the making of the archive in Canvas's own sources, lib/content_zipper.rb
CanvasName canvas_name(const std::string& text);

}  // namespace grade
