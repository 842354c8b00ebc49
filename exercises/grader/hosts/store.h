// SPDX-License-Identifier: MIT-0
/// @file
/// The folder of submissions that a haul becomes.
#pragma once
#include <filesystem>

#include "hosts/haul.h"

namespace grade {

/// The hidden file that says whose a folder of submissions is.
inline constexpr const char* collected_mark = ".collected";

/// Tables in such a folder: when things were handed in, and who those are that did.
inline constexpr const char* times_table = "times.csv";
inline constexpr const char* people_table = "people.csv";

/// Whether such a folder is one.
bool is_collection(const std::filesystem::path& folder);

/// Whether a file of this name there is of the collection itself.
bool is_of_collection(const std::string& name);

/// Whether no student's folder there is called so: hidden, or of the collection itself.
bool is_nobodys(const std::string& name);

/// Student and place of each file that lies there with the same bytes.
std::set<std::pair<std::string, std::string>> unchanged(const Haul& haul,
                                                        const std::filesystem::path& to);

/// Puts each student's files into `to/STUDENT`, in place of what an earlier haul had put there: at
/// every moment a student has the old files or the new ones. Students that are in none of the
/// haul's stay as they are. Files bear the time at which they were handed in, as far as it is
/// known.
/// @returns the students who are there and not in this haul
/// @throws Usage  the folder holds other things
/// @throws NotOwn  something else stands in the place of a student's folder
std::vector<std::string> store(const Haul& haul, const std::filesystem::path& to);

}  // namespace grade
