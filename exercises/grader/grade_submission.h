// SPDX-License-Identifier: MIT-0
/// @file
/// Grades one submission.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cage/cage.h"
#include "exercise.h"
#include "finding.h"
#include "verdict.h"

namespace harness {
class Call;
}

namespace grade {

struct Request {
  Exercise exercise;
  std::filesystem::path submission;  ///< the header, or a folder that holds it
  std::uint64_t seed = 1;            ///< from which all hidden inputs come; 1 is the public one
  cage::Sandbox sandbox = cage::Sandbox::bubblewrap;
  cage::Limits compile_limits{.wall = 100},
      run_limits;                      ///< a compiler waits for nothing but a turn
  int runs = 3;                        ///< with the same inputs, of which the worst counts
  std::vector<std::string> arguments;  ///< of the driver; that of a submission takes none
  std::string only;                    ///< the one test to run, by its name; all, if empty
  bool diagnoses = true;               ///< whether known wrong ways are looked for
  void (*called)(harness::Call& call) = nullptr;  ///< code of ours, in this process
  std::filesystem::path seed_file{};  ///< from which the seed came; empty if it was given openly
};

/// All that is known at the end; the report in words and in JSON is made from this alone.
struct Report {
  std::string exercise;
  std::string version;     ///< of the grader and the exercise together
  std::string submission;  ///< as the caller named it
  std::string sha256;      ///< of its text; empty if there was none
  std::uint64_t seed = 0;
  cage::Sandbox sandbox = cage::Sandbox::bubblewrap;
  Verdict verdict = Verdict::grader_error;
  std::string why;       ///< one or more lines for the student; empty if the tests say it all
  std::string warnings;  ///< of the compiler, if it compiled
  std::string memory;    ///< what a checker of memory found in a run that is not scored
  std::vector<std::string> ignored;
  std::vector<TestResult> tests;
  int score = 0, points = 0;  ///< points earned, points to be had
  bool unreadable = false;    ///< the path could not be read
  bool try_again = false;     ///< with grader_error: a shortage that may pass
  bool no_cage = false;       ///< with grader_error: this machine lets nobody have one; not kept
  double seconds = 0, compile_seconds = 0, run_seconds = 0;  ///< on the clock
  double compile_processor = 0;                              ///< used by the compiler [s]; not kept
  double run_processor = 0;  ///< most that one test used [s]; not kept
};

/// A report on the request in which nothing is known yet: its verdict is a grader_error.
Report blank_report(const Request& request);

/// Reads, compiles, runs and judges; never throws: what goes wrong with us is a grader_error.
/// @param so_far  is shown the report when the submission is read, and after each run
Report grade_submission(const Request& request,
                        const std::function<void(const Report&)>& so_far = {});

/// Adds to a report what a checker of memory says of the submission: that takes another run, which
/// is not scored and cannot change the verdict. For somebody's own code on their own machine.
void check_memory(const Request& request, Report& report);

/// Runs and judges what is compiled already. Of the request, the submission is only named.
Report grade_driver(const Request& request, const cage::File& driver);

/// Judges what the request calls in this process. If it crashes or never comes back, so do we.
Report grade_called(const Request& request);

/// The reason why nobody can be graded.
struct Obstacle {
  std::string why;
  bool try_again = false;  ///< a shortage that may pass
};

/// Grades the exercise's own solution as the request would be, in the same cage. The limits of time
/// become twenty times what it takes here, but at least the usual ones.
/// @returns what is wrong with the grader if the solution is not accepted; at home, where only the
/// starter is there, if that is not judged
std::optional<Obstacle> calibrate(Request& request);

/// The reason why nothing can be graded in the sandbox on this machine, and what to do about it;
/// nothing if it can.
std::optional<std::string> unsafe();

/// SHA-256 in hexadecimal.
std::string sha256(const std::string& text);

/// The version of this grader: a hash of its own code and of the exercise's files.
std::string version(const Exercise& exercise);

}  // namespace grade
