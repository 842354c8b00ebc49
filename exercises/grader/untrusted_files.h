// SPDX-License-Identifier: MIT-0
/// @file
/// Files that others made, looked at without following a link.
#pragma once
#include <sys/stat.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cage/process.h"

namespace grade {

/// Something in a folder: held, but not opened, so that no pipe blocks and no device stirs.
struct Entry {
  cage::File file;
  struct stat about;
  bool is_folder() const { return S_ISDIR(about.st_mode); }
  bool is_link() const { return S_ISLNK(about.st_mode); }
  bool is_regular() const { return S_ISREG(about.st_mode); }
};

/// @param folder  a descriptor
/// @param name  of one thing in it, without a slash; `.` is the folder itself
/// @returns nothing, with errno set, if it is not there
std::optional<Entry> entry(int folder, const std::string& name);

/// Up to so many names in it, sorted.
std::vector<std::string> names_in(const Entry& folder, std::size_t most = 1000);

/// Up to `most` bytes; nothing if it may not be read.
std::optional<std::string> read(const Entry& file, std::size_t most);

}  // namespace grade
