// SPDX-License-Identifier: MIT-0
/// @file
/// Who takes part in a course, and which folder is whose.
#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "class/students.h"
#include "hosts/haul.h"

namespace grade {

/// A row of the roster.
struct Member {
  std::string key;   ///< that no other has, and by which a gradebook knows the student
  std::string name;  ///< empty if the table has none
  std::size_t line = 0;
};

/// The members that a table names: an export of Moodle's participants, one of Canvas's gradebook,
/// one with a column `student`, or just a name a line.
/// @param key  the column to take for the key; empty: the usual one of such a table
/// @throws Usage  it can't be read, lacks the column, or has a key twice
std::vector<Member> read_roster(const std::filesystem::path& file, const std::string& key);

/// A member, with the folder in which something was handed in.
struct Participant {
  Member member;
  std::optional<Student> folder;
};

struct Participants {
  std::vector<Participant> all;          ///< in the roster's order
  std::vector<std::string> unmatched{};  ///< folders of nobody, and of no guest
};

/// Finds each member's folder. It is called like the key; or those who collected it know an address
/// or a number that is the key; or, as Moodle calls it, `NAME_4711_assignsubmission_file`, with a
/// name that no other member has.
/// @param people  by folder, as far as the collection knows
/// @param guests  folders that need be nobody's
/// @throws Usage  two folders are one member's
Participants match(const std::vector<Member>& roster, const std::vector<Student>& folders,
                   const std::map<std::string, Person>& people = {},
                   const std::vector<std::string>& guests = {});

/// All who have a folder, where there is no roster.
Participants with_folders(const std::vector<Student>& folders);

}  // namespace grade
