// SPDX-License-Identifier: MIT-0
/// @file
/// Files that are whole or not there.
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace grade {

/// Writes a file beside its place, brings it to the disk and puts it there by renaming.
/// @throws std::system_error  one line that says what could not be written, and why
void write_whole(const std::filesystem::path& file, std::string_view text);

/// Something else stands in the place of a file or a folder of the grader's. One line says where.
struct NotOwn : std::runtime_error {
  explicit NotOwn(const std::filesystem::path& what);
};

/// Longer than any file that the grader writes [bytes].
inline constexpr std::size_t longest_own = 64 << 20;

/// The content of a file that the grader wrote; nothing if it is not there or may not be read.
/// @throws NotOwn  it is a link, a pipe, a device, a folder, or longer than `most` bytes
std::optional<std::string> read_whole(const std::filesystem::path& file,
                                      std::size_t most = longest_own);

/// Returns whether something other than a file stands there, a link too.
bool no_file(const std::filesystem::path& path);

/// Returns whether something other than a folder stands there, a link too.
bool no_folder(const std::filesystem::path& path);

}  // namespace grade
