// SPDX-License-Identifier: MIT-0
/// @file
/// The kit that the grader takes into the cage.
#pragma once
#include <stdexcept>
#include <string>

#include "cage/cage.h"
#include "installed.h"
#include "kit/make_kit.h"

namespace grade {

/// The kit in a folder, and the compiler that it was made with.
/// @param made  folder with what that compiler has made
/// @throws std::runtime_error  it was not made there
inline cage::Kit kit_in(const std::string& folder, const std::string& made) {
  const auto compiler = made_with(made);
  if (!compiler) throw std::runtime_error("nothing was made ready in " + made);
  const Installed& own = installed();
  return {made + "/harness",   folder,          folder + "/canary",
          folder + "/limited", compiler->path,  own.student_flags,
          own.checked_flags,   compiler->shown, compiler->libraries};
}

/// This grader's.
inline cage::Kit own_kit() {
  return kit_in(installed().kit, made_folder());
}

}  // namespace grade
