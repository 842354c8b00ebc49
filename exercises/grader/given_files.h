// SPDX-License-Identifier: MIT-0
/// @file
/// Files and folders that somebody names, and has written by hand.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace grade {

/// Nothing if it is no whole number, or none below 2^64.
std::optional<std::uint64_t> whole_number(const std::string& text);

/// A file of at most a megabyte, perhaps where a link leads to, without the mark that some editors
/// begin a file with; nothing if it cannot be read, is longer, or is no file.
std::optional<std::string> small_file(const std::filesystem::path& file);

/// The seed that a file holds.
/// @throws Usage  it can't be read, or holds anything else, which is not printed
std::uint64_t seed_in(const std::filesystem::path& file);

bool lies_within(const std::filesystem::path& inner, const std::filesystem::path& outer);

}  // namespace grade
