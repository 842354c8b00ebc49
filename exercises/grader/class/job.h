// SPDX-License-Identifier: MIT-0
/// @file
/// One submission of a class, and whether it is graded already.
#pragma once
#include <optional>
#include <vector>

#include "class/class.h"
#include "class/students.h"
#include "grade_submission.h"

namespace grade {

struct Job {
  Student student;
  Exercise exercise;
  std::filesystem::path out;  ///< where its report is kept
  bool asked = true;          ///< it was handed in, or had to be; else nothing is graded
};

/// Every student with every exercise, asked or not.
std::vector<Job> all_jobs(const Class& work, const std::vector<Student>& students,
                          const std::vector<Exercise>& exercises);

/// The jobs of one shard.
std::vector<Job> jobs_of(const std::vector<Job>& jobs, const Shard& shard);

/// The report that is kept; a GRADER_ERROR if there is none.
Report kept_report(const Job& job);

/// Returns whether the kept report is of this grader, this seed and these very bytes, and no
/// GRADER_ERROR.
bool is_done(const Job& job, std::uint64_t seed);

/// The arguments with which the grader grades it.
/// @param limits  as write_limits() gives them
std::vector<std::string> arguments(const Job& job, const Class& work, const std::string& limits);

}  // namespace grade
