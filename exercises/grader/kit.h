// SPDX-License-Identifier: MIT-0
/// @file
/// The kit that the grader takes into the cage.
#pragma once
#include <string>

#include "cage/cage.h"
#include "installed.h"

namespace grade {

/// The kit in a folder, and the compiler that it was made with.
inline cage::Kit kit_in(const std::string& folder) {
  const Installed& own = installed();
  return {folder + "/harness", folder,
          folder + "/canary",  folder + "/limited",
          own.compiler,        own.student_flags,
          own.checked_flags,   own.shown_to_compiler,
          own.shown_to_checked};
}

}  // namespace grade
