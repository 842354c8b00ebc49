// SPDX-License-Identifier: MIT-0
/// @file
/// What of the grader is made by the compiler of the machine that it grades on: the header that
/// every exercise is given, compiled before, and the harness.
#pragma once
#include <filesystem>
#include <optional>

#include "kit/compiler.h"

namespace grade {

/// The folder in which it is kept: the kit's own, or, where this user can't write there and nobody
/// has made it, the user's state.
std::filesystem::path made_folder();

/// The compiler that it was made with there; nothing if it was not, or if another one lies in that
/// one's place by now.
std::optional<Compiler> made_with(const std::filesystem::path& folder);

/// Makes it. Each file is whole or not there, and what says that all are comes last.
/// @throws std::runtime_error  the compiler's own words
/// @throws std::system_error  it can't be written
void make_kit(const std::filesystem::path& folder, const std::filesystem::path& compiler);

}  // namespace grade
