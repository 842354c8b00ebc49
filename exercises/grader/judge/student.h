// SPDX-License-Identifier: MIT-0
/// @file
/// The student's code, as the judge sees it: numbers in, numbers out.
#pragma once
#include <memory>
#include <vector>

#include "harness/force.h"
#include "judge/path.h"
#include "judge/program.h"

namespace judge {

/// A program of the session, for as long as this lives. A test makes one, or more to see whether
/// anything is remembered between runs.
class Student {
 public:
  /// @throws Stopped if the code of an earlier test did not end as it should
  Student();

  /// Calls a function of the exercise's harness.h.
  /// @param function  which, counted from 0
  /// @param arguments  what the harness reads
  /// @param wanted  how many numbers a right answer has
  /// @throws Stopped if no such answer comes
  std::vector<double> call(int function, const std::vector<double>& arguments, std::size_t wanted);

  /// A method under a force that only the judge knows; each evaluation is kept.
  Path watch(const Start& start, double h, int steps, const Acceleration& acceleration,
             int function = 0);

  /// A method under a force that the program evaluates: for long runs.
  /// @param every  so many steps from one state of the answer to the next; divides `steps`
  Path run(const Start& start, double h, int steps, int every, const harness::Force& force,
           int function = 0);

 private:
  std::unique_ptr<Program> program_;
  std::size_t place_ = 0;  ///< among the test's programs
  Acceleration acceleration_;
  std::vector<Evaluation> evaluations_;
};

}  // namespace judge
