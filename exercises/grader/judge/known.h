// SPDX-License-Identifier: MIT-0
/// @file
/// The known wrong ways to do an exercise, compiled: a student's mistake is one of them if it
/// answers as they do.
#pragma once
#include <string>
#include <vector>

#include "harness/call.h"
#include "judge/path.h"

namespace judge {

/// One call of a student's function, and what came of it.
struct Exchange {
  int function = 0;
  std::vector<double> arguments;
  std::vector<Evaluation> evaluations;  ///< of a force that only the judge knows, as it was told
  std::vector<double> answer;
};

/// The exchanges of each program in which the student's code ran, in their order.
using Programs = std::vector<std::vector<Exchange>>;

/// An exercise's solution and its wrong ways, each beside its harness.h; known.mjs writes it.
class Known {
 public:
  struct Way {
    const char* says;  ///< what a student is told who goes it
    void (*answer)(harness::Call& call);
  };

  /// Is known from then on by the exercise's name.
  Known(const char* exercise, void (*right)(harness::Call& call), std::vector<Way> wrong);

  /// The exercise's solution, to be called in this process; null if it is not known.
  static void (*solution(const std::string& exercise))(harness::Call& call);

  /// The wrong ways whose answers are these in all exchanges, to ten digits, and not the right ones
  /// in one of them at least. Two ways that cannot be told apart are named together, and more than
  /// two are not.
  static std::vector<std::string> recognised(const std::string& exercise, const Programs& programs);

  /// The first exchange that is wrong; null if there is none, or if others must come before it.
  static const Exchange* first_wrong(const std::string& exercise, const Programs& programs);

  /// Returns whether this is the right answer, to ten digits, if it is all that is asked.
  static bool is_right(const std::string& exercise, const Exchange& exchange);
};

}  // namespace judge
