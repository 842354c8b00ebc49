// SPDX-License-Identifier: MIT-0
/// @file
/// The marks of an assignment, after what being late takes.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "class/results.h"
#include "course/course.h"
#include "course/handed_in_at.h"
#include "course/late.h"
#include "course/roster.h"

namespace grade {

/// One exercise of one student.
struct Mark {
  std::string exercise;
  bool asked = false;         ///< handed in, or due by now; else there is no mark
  std::string verdict;        ///< empty if nothing was handed in at all
  std::optional<int> earned;  ///< by the tests; nothing without a grade
  std::optional<int> points;  ///< what counts
  int of = 0;
  std::string handed_in, due;  ///< on the course's clocks; empty if unknown
  long days_late = 0, seconds_late = 0;
  int taken = 0;
  std::string late;  ///< in words
};

struct StudentMarks {
  std::string student, name, folder;  ///< printable
  std::vector<Mark> marks;            ///< one for each exercise
};

struct Marks {
  std::string course, assignment;
  std::vector<std::string> exercises;
  std::vector<StudentMarks> students;
  std::vector<std::string> unmatched{};  ///< folders of nobody on the roster
};

/// What was asked, summed up.
struct Total {
  int points = 0, of = 0;
  bool any = false;   ///< anything was asked
  bool whole = true;  ///< and all of it has a mark

  void add(const Mark& mark);
};

/// The marks of those who take part. While a folder is nobody's, whoever has none has no mark.
/// @param jobs  of all folders with all exercises, folder by folder in the order of `all`
Marks marks_of(const Course& course, const Assignment& assignment, const Participants& students,
               const std::vector<Job>& jobs, std::uint64_t seed, const HandedInAt& handed_in_at);

/// What is kept of an assignment, for the table of all and for programs.
std::string marks_json(const Marks& marks);

/// Reads it back, as far as tables need it; nothing if it is none.
std::optional<Marks> marks_from(std::string_view json);

/// A row for each exercise that was late.
std::string late_csv(const Marks& marks);

/// A row for each student; for each assignment a column for each exercise, the sum and what it is
/// out of. A cell without a mark is empty, and so is its sum.
/// @param roster  who comes first, in this order
std::string grades_of_course(const std::vector<Marks>& assignments,
                             const std::vector<Member>& roster);

}  // namespace grade
