// SPDX-License-Identifier: MIT-0
/// @file
/// The grading that is under way: what a test needs to know, and where it leaves what it found.
#pragma once
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "finding.h"
#include "judge/known.h"
#include "judge/program.h"
#include "judge/rounding.h"
#include "verdict.h"

namespace judge {

/// One grading at a time in a process, so that a test can be written without passing it about.
struct Session {
  // Given.
  std::function<std::unique_ptr<Program>()> begin;  ///< begins a program with the student's code
  std::uint64_t seed = 1;
  std::string only;       ///< the one test to run, by its name; all, if empty
  bool diagnoses = true;  ///< whether known wrong ways are looked for
  bool remembers = true;  ///< whether exchanges are kept, for diagnoses

  // Found.
  std::string exercise;  ///< of the tests that run
  Programs programs;     ///< of the test that runs
  std::string given;     ///< by that test besides, to be said behind the input of each finding
  std::vector<grade::TestResult> tests;
  grade::Verdict ended =
      grade::Verdict::accepted;  ///< how the student's code ended; accepted: as it should
  std::string why;               ///< if it did not end as it should
  std::string printed;           ///< on stderr, up to the first program that ended otherwise
  double processor = 0;          ///< most that one test used [s]
  double wall = 0;               ///< used by all programs that have ended, on the clock [s]

  bool stopped() const { return ended != grade::Verdict::accepted; }
};

/// The session of this process.
Session& session();

/// Runs the tests with this tag, or the only one that is asked for; what they found is in the
/// session.
void run_tests(const std::string& exercise);

/// The tests with this tag, not run: their names and points.
std::vector<grade::TestResult> tests_of(const std::string& exercise);

/// Thrown out of a test when the student's code does not go on.
struct Stopped {};

/// A finding that is off by so much and may be off by the tolerance. What was asked, what is right
/// and what came are still to be said.
/// @param unit  of both, such as " m"
grade::Finding off_by(double off, const Tolerance& tolerance, const std::string& unit = "");

/// Notes what was found, and ends the test if it did not hold. Of much that holds, only some is
/// kept.
void check(grade::Finding finding);

}  // namespace judge
