// SPDX-License-Identifier: MIT-0
/// @file
/// The student's code, as the judge sees it: numbers in, numbers out.
#pragma once
#include <memory>
#include <vector>

#include "cage/process.h"
#include "harness/force.h"
#include "judge/path.h"

namespace judge {

/// A driver in its cage, for as long as this lives, or code of ours that is called in this process.
/// A test makes one, or more to see whether anything is remembered between runs.
class Student {
 public:
  /// @throws Stopped if the code of an earlier test did not end as it should
  Student();

  /// Notes how the driver ended, if that was not as it should.
  ~Student();

  /// Calls a function of the exercise's harness.h.
  /// @param function  which, counted from 0
  /// @param arguments  what the harness reads
  /// @param wanted  how many numbers a right answer has
  /// @throws Stopped if no such answer comes
  std::vector<double> call(int function, const std::vector<double>& arguments, std::size_t wanted);

  /// A method under a force that only the judge knows; each evaluation is kept.
  Path watch(const Start& start, double h, int steps, const Acceleration& acceleration,
             int function = 0);

  /// A method under a force that the driver evaluates: for long runs.
  /// @param every  so many steps from one state of the answer to the next; divides `steps`
  Path run(const Start& start, double h, int steps, int every, const harness::Force& force,
           int function = 0);

 private:
  Vec evaluate(const Vec& x, const Vec& v, double t);
  std::vector<double> call_here(int function, const std::vector<double>& arguments) noexcept;
  std::vector<double> ask_driver(int function, const std::vector<double>& arguments,
                                 std::size_t wanted);
  std::vector<double> receive(std::size_t count);
  void answer_question();
  void stop();

  std::unique_ptr<cage::Process> process_;
  std::size_t program_ = 0;  ///< which of the test's
  Acceleration acceleration_;
  std::vector<Evaluation> evaluations_;
};

}  // namespace judge
