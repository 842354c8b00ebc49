// SPDX-License-Identifier: MIT-0
/// @file
/// Files that are whole or not there.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace grade {

/// Writes a file beside its place, brings it to the disk and puts it there by renaming.
/// @throws std::system_error  one line that says what could not be written, and why
void write_whole(const std::filesystem::path& file, std::string_view text);

/// The content of a file; nothing if it cannot be read.
std::optional<std::string> read_whole(const std::filesystem::path& file);

}  // namespace grade
