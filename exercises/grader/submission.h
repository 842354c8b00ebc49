// SPDX-License-Identifier: MIT-0
/// @file
/// Reads a submission once, and never looks at its path again.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace grade {

/// The text that a student handed in, or why it was not taken.
struct Submission {
  std::string text;
  std::string refused;               ///< empty if it was taken; else one line for the student
  bool unreadable = false;           ///< the path itself cannot be read: the caller's mistake
  std::vector<std::string> ignored;  ///< names beside it that were not looked at
  std::string name;                  ///< of the file, fit to be shown
  bool linked = false;               ///< the file has other names, as in a backup of hard links
};

/// Reads a header without following links: a regular file of at most 64 KiB of UTF-8 text.
/// @param path  the file, or a folder that holds `header` or `chapter/header`
/// @param chapter  such as `2-euler`
/// @param header  such as `orbit-drift.h`
Submission read_submission(const std::filesystem::path& path, const std::string& chapter,
                           const std::string& header);

}  // namespace grade
