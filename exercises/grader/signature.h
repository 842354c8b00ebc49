// SPDX-License-Identifier: MIT-0
/// @file
/// A function that is not what the exercise asked for.
#pragma once
#include <string>

#include "diagnostics.h"

namespace grade {

/// The signatures that were wanted and found, from an error in
/// `const harness::Wanted<void(Vec&)> wanted = step;`. Empty if the error is another.
std::string wanted_and_found(const Diagnostic& error);

/// The remark on a function, lambda or std::function of another signature that can be called all
/// the same. Empty if the warning is another.
std::string another_form(const Diagnostic& warning);

}  // namespace grade
