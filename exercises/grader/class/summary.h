// SPDX-License-Identifier: MIT-0
/// @file
/// The counts that the summary page shows.
#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "class/results.h"

namespace grade {

struct TestCount {
  std::string name;
  int points = 0;
  std::size_t held = 0;
};

/// The outcome of one exercise. Whoever's submission was not taken, or has no grade, is not among
/// those that were judged.
struct ExerciseCount {
  std::size_t judged = 0;
  std::vector<TestCount> tests;
  std::map<Verdict, std::size_t> verdicts;
};

ExerciseCount count(const Results& results, std::size_t exercise);

}  // namespace grade
