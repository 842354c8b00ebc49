// SPDX-License-Identifier: MIT-0
/// @file
/// All reports of a class, side by side.
#pragma once
#include <string>
#include <vector>

#include "class/job.h"

namespace grade {

struct Results {
  std::vector<Student> students;
  std::vector<Exercise> exercises;
  std::vector<Report> reports;  ///< student by student, each with every exercise
  std::vector<bool> asked{};  ///< beside the reports: whether there is one; not of an exercise that
                              ///< the student neither handed in nor had to

  const Report& report(std::size_t student, std::size_t exercise) const {
    return reports[student * exercises.size() + exercise];
  }

  bool is_asked(std::size_t student, std::size_t exercise) const {
    return asked[student * exercises.size() + exercise];
  }

  /// The reports that are there.
  std::vector<Report> all() const;
};

/// Reads what is kept for these jobs.
Results collect(const std::vector<Student>& students, const std::vector<Exercise>& exercises,
                const std::vector<Job>& jobs);

/// The jobs whose reports came from another grader, or with another seed: they cannot stand in one
/// table with the others.
std::vector<Job> stale(const std::vector<Job>& jobs, const Results& results, std::uint64_t seed);

/// One row for each student, one column for each exercise, the sum, and what could be had; a cell
/// without a grade is empty, and so is its sum. So is a cell of what was not asked.
std::string grades_csv(const Results& results);

/// One row for each submission.
std::string report_csv(const Results& results);

/// A page that needs nothing but itself.
std::string summary_html(const Results& results, const std::string& title);

}  // namespace grade
