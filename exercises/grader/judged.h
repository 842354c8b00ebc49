// SPDX-License-Identifier: MIT-0
/// @file
/// The outcome of a run of all tests, and of several runs.
#pragma once
#include <string>
#include <vector>

#include "finding.h"
#include "verdict.h"

namespace grade {

struct Judged {
  Verdict verdict = Verdict::grader_error;
  std::string why;  ///< if the code did not end as it should
  std::vector<TestResult> tests;

  int score() const;
};

/// The verdict by the sum of the tests, all of which ran.
Verdict verdict(const Judged& judged);

/// Runs of the same code with the same inputs come to one: the worst of them. If the code answered
/// one of them otherwise than another, `why` says so.
/// @param runs  at least one
Judged worst(std::vector<Judged> runs);

}  // namespace grade
