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
  std::vector<Report> reports;        ///< student by student, each with every exercise
  std::vector<bool> are_handed_in{};  ///< beside the reports
  bool assigned = false;              ///< what was not handed in counts, as nothing

  const Report& report(std::size_t student, std::size_t exercise) const {
    return reports[student * exercises.size() + exercise];
  }

  /// Whether its score, or the lack of one, belongs in the sum.
  bool counts(std::size_t student, std::size_t exercise) const {
    return assigned || are_handed_in[student * exercises.size() + exercise];
  }
};

/// Reads what is kept for these jobs.
Results collect(const std::vector<Student>& students, const std::vector<Exercise>& exercises,
                const std::vector<Job>& jobs);

/// The jobs whose reports came from another grader, or with another seed: they cannot stand in one
/// table with the others.
std::vector<Job> stale(const std::vector<Job>& jobs, const Results& results, std::uint64_t seed);

/// One row for each student, one column for each exercise, the sum, and what could be had; a cell
/// without a grade is empty, and so is its sum. So is a cell of what was not handed in, unless all
/// had to.
std::string grades_csv(const Results& results);

/// One row for each submission.
std::string report_csv(const Results& results);

/// A page that needs nothing but itself.
std::string summary_html(const Results& results);

}  // namespace grade
