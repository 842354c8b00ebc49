// SPDX-License-Identifier: MIT-0
/// @file
/// The seam between the judges and whatever runs a student's code: a driver in its cage, a module
/// in the page of a book, or code of ours in this process.
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "harness/given.h"

namespace judge {

/// A program with the student's code, from its beginning to its end.
class Program {
 public:
  Program() = default;
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Notes in the session how the program ended, if that was not as it should.
  virtual ~Program() = default;

  /// The answer of a function of the exercise's harness.h.
  /// @param function  which, counted from 0
  /// @param arguments  what the harness reads
  /// @param wanted  how many numbers a right answer has
  /// @param acceleration  of a force that only the judge knows; null if there is none
  /// @throws Stopped if no such answer comes; why is in the session then
  virtual std::vector<double> answer(int function, const std::vector<double>& arguments,
                                     std::size_t wanted, const Acceleration& acceleration) = 0;
};

}  // namespace judge
