// SPDX-License-Identifier: MIT-0
/// @file
/// What a system handed out, as far as it is taken.
#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "course/local_time.h"
#include "untrusted_files.h"

namespace grade {

/// One header of one student.
struct HandedFile {
  std::string student;      ///< the name of the folder that it comes into
  std::string place;        ///< there: `orbit-drift.h` or `2-euler/orbit-drift.h`
  std::string called;       ///< as it came
  std::string text;         ///< any bytes
  Instant file_time{};      ///< when the file was last written, says the file
  std::string handed_in{};  ///< when it was handed in, as a table of times has it; empty if unknown
};

/// Who somebody is, as a system's table says it; what it does not say is empty.
struct Person {
  std::string name, id, email;
};

struct Haul {
  std::set<std::string> students;        ///< all, those too of whom nothing was taken
  std::map<std::string, Person> people;  ///< by the name of their folder, as far as known
  bool bears_times = false;              ///< whether the files' own times are those of handing in
  std::set<std::string> late;            ///< of these, as the system says
  std::vector<HandedFile> files;
  std::vector<std::string> not_taken;  ///< what, and why
  std::vector<std::string> notes;
};

/// Takes a header that lies at `place`, whose last part is the name that it came with.
void take_file(Haul& haul, const std::string& student, const std::string& chapter,
               const std::string& name, const Entry& file);

/// Takes the headers in a student's folder and in those of its folders that are chapters. Nothing
/// is followed that is a link.
void take_folder(Haul& haul, const std::string& student, const Entry& folder);

/// Leaves one file in each place: the one that is later by more than a minute, or else the one with
/// the highest number, `orbit-drift (2).h` before `orbit-drift.h`. Archives bear the times of their
/// making, so that less than a minute says nothing. Notes what was chosen.
void leave_one_each(Haul& haul);

}  // namespace grade
