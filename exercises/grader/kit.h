// SPDX-License-Identifier: MIT-0
/// @file
/// What the grader takes into the cage.
#pragma once
#include <iterator>
#include <string>

#include "cage/cage.h"
#include "installed.h"

namespace grade {

/// The kit in a folder, and the compiler that it was made with.
inline cage::Kit kit_in(const std::string& folder) {
  return {folder + "/harness",
          folder,
          folder + "/canary",
          installed::compiler,
          {std::begin(installed::student_flags), std::end(installed::student_flags)},
          {std::begin(installed::checked_flags), std::end(installed::checked_flags)},
          {std::begin(installed::shown_to_compiler), std::end(installed::shown_to_compiler)}};
}

}  // namespace grade
