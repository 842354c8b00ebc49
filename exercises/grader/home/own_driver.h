// SPDX-License-Identifier: MIT-0
/// @file
/// A student's code, compiled to be asked at home.
#pragma once
#include <string>

#include "compile.h"
#include "grade_submission.h"
#include "judge/driver.h"
#include "judge/student.h"

namespace grade {

/// A header with its exercise's harness, compiled.
class OwnDriver {
 public:
  explicit OwnDriver(const Request& request);

  /// Why there is none, for the student; empty if there is one.
  std::string why_not;
  bool unreadable = false;  ///< the header could not be read

  const cage::File& driver() const { return compiled_.driver; }

  /// Begins a program with it, in the session; this object must outlive it.
  judge::Student begin() const;

 private:
  cage::Kit kit_;
  Compiled compiled_;
  judge::Caged caged_;
};

/// The exercise's solution as such a program, in this process.
judge::Student begin_right(const std::string& exercise);

}  // namespace grade
