// SPDX-License-Identifier: MIT-0
/// @file
/// The command that the grader was given.
#pragma once
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "class/class.h"
#include "course/grade_course.h"
#include "grade_submission.h"
#include "hosts/collect.h"
#include "hosts/hand_back.h"
#include "options.h"
#include "report/folder.h"

namespace grade {

/// A command with everything that it takes; checked.
struct Command {
  What what = What::nothing;
  Request request;  ///< of one submission
  std::optional<std::filesystem::path> out;
  std::set<Emit> emits;
  bool limits_given = false;  ///< by the grader of a class, that calibrated them
  bool unchecked = false;     ///< for a class: no word on how it uses memory
  bool exit_by_verdict = false;
  bool at_home = false;           ///< for whoever wrote it: where no cage can be had, without one
  bool cage_if_any = false;       ///< the same, for others' code where that can't read a secret
  std::string listed;             ///< part of the names that are listed; empty for all
  bool all = false;               ///< of the tests that failed in full
  Class classroom;                ///< of a whole class
  CourseWork course;              ///< and of a course
  Collection collection;          ///< that is brought in
  HandBack handed_back;           ///< and what goes out
  std::filesystem::path reports;  ///< that one file of a host's is made of
  std::filesystem::path own;      ///< header whose own main is run; folder to start in
};

/// Bad input: one line that says what is wrong and what to do.
struct Usage : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Reads the command line; prints the help if that is all that was asked for.
/// @throws Usage
Command read_command_line(int argc, char** argv);

}  // namespace grade
