// SPDX-License-Identifier: MIT-0
/// @file
/// A function that is not what the exercise asked for.
#pragma once
#include <string>

#include "diagnostics.h"

namespace grade {

/// What was wanted and what was found, from an error in `void (*const wanted)(...) = step;`. Empty
/// if the error is another.
std::string wanted_and_found(const Diagnostic& error);

}  // namespace grade
