// SPDX-License-Identifier: MIT-0
/// @file
/// From a submission to a driver, or to a message that helps.
#pragma once
#include <optional>
#include <string>

#include "cage/cage.h"
#include "verdict.h"

namespace grade {

struct Compiled {
  cage::File driver;              ///< the program, if there is one
  std::optional<Verdict> failed;  ///< why there is none
  std::string message;   ///< for the student: first error, or the warnings; no path of ours
  double processor = 0;  ///< used [s]
};

/// @param text  the submission
/// @param header  its name, such as `orbit-drift.h`
/// @param harness  the exercise's harness.h
Compiled compile(const std::string& text, const std::string& header, const std::string& harness,
                 cage::Sandbox sandbox, const cage::Kit& kit, const cage::Limits& limits,
                 cage::Build build = cage::Build::scored);

}  // namespace grade
