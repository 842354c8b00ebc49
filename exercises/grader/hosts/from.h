// SPDX-License-Identifier: MIT-0
/// @file
/// What systems hand out, read.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "hosts/haul.h"

namespace grade {

/// The folder that somebody named, held. Links on the way to it are theirs.
/// @throws Usage  it can't be read, or is an archive
Entry folder_named(const std::filesystem::path& path);

/// Moodle's *Download all submissions*, unpacked, with folders or without.
/// @see https://docs.moodle.org/en/Using_Assignment
Haul from_moodle(const std::filesystem::path& from);

/// Canvas's *Download Submissions*, unpacked.
Haul from_canvas(const std::filesystem::path& from);

/// A folder for each student, as by hand.
Haul from_folders(const std::filesystem::path& from);

/// The last moment at which what this student hands in is taken; nothing if it always is.
using Until = std::function<std::optional<Instant>(const std::string& student)>;

/// Git repositories: a folder with one for each student, or a table with the columns `student` and
/// `repository`. Of each the last commit of its branch is read, or the last until then by the time
/// that the commit itself bears. A header was handed in by the commit that last changed it.
Haul from_git(const std::filesystem::path& from, const Until& until);

}  // namespace grade
