// SPDX-License-Identifier: MIT-0
/// @file
/// Grades what a class handed in: submissions/STUDENT/CHAPTER/EXERCISE.h.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "class/students.h"
#include "exercise.h"
#include "report/folder.h"

namespace grade {

/// The i-th of n parts of the work; all of it if n is 1.
struct Shard {
  std::size_t part = 1, of = 1;
};

struct Class {
  std::filesystem::path submissions;
  std::filesystem::path results;    ///< becomes results/STUDENT/CHAPTER/EXERCISE, and the tables
  std::vector<Exercise> exercises;  ///< to grade; none: all that count
  std::vector<Exercise> assigned;   ///< that all have to hand in; none: all that anybody did count
  std::uint64_t seed = 1;
  std::filesystem::path seed_file;  ///< from which the seed came; empty if it was given openly
  std::size_t jobs = 1;             ///< submissions at a time, of a student one
  Shard shard;
  std::string round{};  ///< its name, with that of the course, whose table has the grades; or empty
  std::set<Emit> emits;
  std::function<bool(const Student&)> takes_part;  ///< empty: everybody does
  /// Whether what was assigned and not handed in counts as such by now; empty: it does.
  std::function<bool(const Student&)> is_due;

  bool partial() const { return !exercises.empty(); }

  /// The folder of the tables: those of a part of the exercises never replace those of all.
  std::filesystem::path tables() const { return partial() ? results / part_folder : results; }
  static constexpr const char* part_folder = "part";
};

/// Grades every submission that has no report yet from this grader and with this seed, each in a
/// process of its own; then, if this was not a shard, makes the tables and the summary page.
/// @returns the exit code: 0; 3 if there are no submissions; 42 or 75 if the grader failed
int grade_class(const Class& work);

}  // namespace grade
