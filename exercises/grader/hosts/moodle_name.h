// SPDX-License-Identifier: MIT-0
/// @file
/// Names that Moodle gives to what was handed in.
#pragma once
#include <optional>
#include <string>

namespace grade {

/// `Ada Lovelace_4711_assignsubmission_file_orbit-drift.h`, taken apart. Moodle lets no `_` into
/// the name that it begins with, so that nobody can write another's number in front of it.
struct MoodleName {
  std::string name;            ///< `Ada Lovelace`, without the characters that Moodle takes away
  std::string number;          ///< `4711`: of the participant, in this assignment alone
  std::string kind;            ///< `file`, or `onlinetext` and the like
  std::string file;            ///< `orbit-drift.h`; empty for a participant's folder
  std::string folder() const;  ///< as Moodle calls it where it makes folders
};

/// The name of a participant's folder, with a `_` at the end or without, or that of a file where
/// Moodle makes no folders; nothing if it is neither.
/// @see the downloader and the importer of feedback in Moodle's own sources, mod/assign
std::optional<MoodleName> moodle_name(const std::string& text);

/// A full name as Moodle makes the beginning of such a name of it.
std::string as_moodle_writes(const std::string& name);

}  // namespace grade
