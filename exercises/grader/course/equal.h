// SPDX-License-Identifier: MIT-0
/// @file
/// Work that is the same of two students: places to look, no verdicts.
#pragma once
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "grade_submission.h"

namespace grade {

/// One student's report on an exercise.
struct Handed {
  std::string student;  ///< printable
  Report report;
};

struct EqualWork {
  std::string exercise;
  std::string what;  ///< `file` or `wrong numbers`
  std::vector<std::string> students;
  std::string where;  ///< the verdict of the file, or the tests that say the numbers
};

/// What a student alone would answer: of each test that did not hold, and that the grader knows no
/// common reason for, the test and what came. Numbers of fewer than ten digits are not enough, and
/// neither are those that stand in the question or in the right answer.
std::set<std::pair<std::string, std::string>> wrong_numbers(const Report& report);

/// Files with the same bytes, and wrong numbers with the same digits, of one exercise. Those of the
/// starter are nobody's own, and right numbers are equal by nature.
/// @param starters  hashes of the starter, as it may be saved
/// @param starter  its report
std::vector<EqualWork> equal_work(std::vector<Handed> all, const std::set<std::string>& starters,
                                  const std::optional<Report>& starter);

/// A row for each.
std::string equal_csv(const std::vector<EqualWork>& all);

}  // namespace grade
