// SPDX-License-Identifier: MIT-0
/// @file
/// A course of a term: who takes part, what is handed in by when, and what being late costs.
#pragma once
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "course/local_time.h"
#include "exercise.h"

namespace grade {

/// What being late costs, of each exercise.
struct LateRule {
  std::chrono::minutes grace{0};  ///< within which nobody is late
  int points_a_day = 0;           ///< taken for each day begun
  std::optional<int> days;        ///< after which nothing counts; nothing: it always does
};

/// What is handed in together and graded with one seed.
struct Assignment {
  std::string name;
  std::vector<Exercise> exercises;  ///< in the book's order
  std::optional<Instant> opens;
  Instant due;
  std::filesystem::path submissions;
  std::filesystem::path seed_file;  ///< empty: the public seed
  std::optional<LateRule> late;     ///< nothing: what is late counts in full
};

/// More time for one student.
struct Extension {
  std::string student, assignment;
  Instant due;
  std::string place;  ///< in the file
};

struct Course {
  std::filesystem::path file;
  std::string name;
  TimeZone zone{"UTC"};
  std::filesystem::path roster;  ///< empty: whoever has a folder takes part
  std::string key;  ///< column of the roster that names a student; empty: the usual one
  std::filesystem::path results;
  std::filesystem::path times;      ///< table of when what was handed in; empty: the collection's
  bool times_of_files = false;      ///< the files say it, and no table
  bool show_seed = true;            ///< to students
  std::vector<std::string> guests;  ///< folders of people who are on no roster, and need not be
  std::vector<Assignment> assignments;
  std::vector<Extension> extensions;
};

/// The course that a file describes.
/// @throws Usage  in one line, with the place in the file and what to write instead
Course read_course(const std::filesystem::path& file);

/// The assignment of that name.
/// @throws Usage  there is none
const Assignment& assignment_named(const Course& course, const std::string& name);

/// The end of an assignment for this student.
Instant due(const Course& course, const Assignment& assignment, const std::string& student);

/// The last moment at which something handed in by this student counts; nothing if it always does.
std::optional<Instant> last_moment(const Course& course, const Assignment& assignment,
                                   const std::string& student);

}  // namespace grade
