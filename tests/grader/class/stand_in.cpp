// SPDX-License-Identifier: MIT-0
// The grader's command line and classes around a judge that believes what a submission says of
// itself in its first line:
//   // score 4       its points, of ten
//   // slow          takes as long as STAND_IN_SECONDS says, then full marks
//   // slow 4        the same, with this many points after the first run
//   // crash         the grader dies
//   // fails         the grader fails, and will again
//   // again         the grader fails for want of something
// And in further lines of what did not hold:
//   // got 0.5      what came, in place of nothing
//   // looks like x a diagnosis
//   // plot         a picture
// Exercises lie in the folder STAND_IN_EXERCISES, if there is one. What it grades is noted in the
// file STAND_IN_LOG; STAND_IN_VERSION is the grader's version. Of the exercise that STAND_IN_BROKEN
// names, it cannot grade the solution.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>

#include "exit_codes.h"
#include "grade_submission.h"
#include "home/level_own.h"
#include "home/play_own.h"
#include "home/ready.h"
#include "judge/session.h"
#include "submission.h"

namespace {

std::string setting(const char* name, const std::string& otherwise) {
  const char* value = std::getenv(name);
  return value ? value : otherwise;
}

// What stands behind this in a line of its own; empty if it is in none.
std::string behind(const std::string& what, const std::string& text) {
  const std::size_t at = text.find("\n// " + what);
  if (at == text.npos) return "";
  const std::size_t begin = at + 4 + what.size();
  return text.substr(begin, text.find('\n', begin) - begin);
}

std::vector<grade::TestResult> results(int score, const std::string& text = "") {
  grade::Finding failed;
  failed.asked = "to be right";
  failed.got = behind("got ", text);
  if (const std::string like = behind("looks like ", text); !like.empty())
    failed.diagnoses = {like};
  if (text.find("\n// plot") != text.npos)
    failed.plot = {"a <curve>", "t", "x", {{"yours", {0, 1, 2}, {0, 1, 4}}}};
  return {{"the first test", 4, true, score >= 4, {}},
          {"the second test", 6, true, score == 10, {failed}}};
}

using SoFar = std::function<void(const grade::Report&)>;

// Takes its time, with some points at first.
void be_slow(const std::string& text, grade::Report& report, const SoFar& so_far) {
  int score = 0;
  if (std::sscanf(text.c_str(), "// slow %d", &score) == 1 && so_far) {
    report.tests = results(score);
    so_far(report);
  }
  usleep(static_cast<useconds_t>(1e6 * std::stod(setting("STAND_IN_SECONDS", "1000"))));
}

void decide(const std::string& text, grade::Report& report, const SoFar& so_far) {
  if (text.starts_with("// crash")) std::abort();
  if (text.starts_with("// fails") || text.starts_with("// again")) {
    report.try_again = text.starts_with("// again");
    return;
  }
  report.score = 10;
  if (text.starts_with("// slow")) {
    be_slow(text, report, so_far);
  } else if (std::sscanf(text.c_str(), "// score %d", &report.score) != 1) {
    report.score = 0;
    report.verdict = grade::Verdict::compile_error;
    report.why = text;
    return;
  }
  report.tests = results(report.score, text);
  report.verdict = report.score == 10  ? grade::Verdict::accepted
                   : report.score == 0 ? grade::Verdict::wrong_answer
                                       : grade::Verdict::partial;
}

}  // namespace

std::vector<grade::TestResult> judge::tests_of(const std::string&) {
  return {{"the first test", 4, false, false, {}}, {"the second test", 6, false, false, {}}};
}

namespace grade {

std::string Exercise::chapter() const {
  return name.substr(0, name.find('/'));
}

std::string Exercise::task() const {
  return name.substr(name.find('/') + 1);
}

std::string Exercise::header() const {
  return task() + ".h";
}

std::vector<Exercise> exercises() {
  std::vector<Exercise> all;
  for (const char* name : {"1-first/one", "1-first/two", "2-second/three"}) {
    const std::filesystem::path folder = setting("STAND_IN_EXERCISES", "");
    all.push_back({name, folder.empty() ? folder : folder / name});
  }
  return all;
}

std::optional<Exercise> exercise(const std::string& name) {
  for (const Exercise& one : exercises()) {
    if (one.name == name) return one;
  }
  return {};
}

std::string nearest_exercise(const std::string&) {
  return "1-first/one";
}

std::string version(const Exercise&) {
  return setting("STAND_IN_VERSION", "one");
}

std::optional<std::string> unsafe() {
  if (!std::getenv("STAND_IN_UNSAFE")) return {};
  return "the cage does not hold; install bubblewrap";
}

std::string sha256(const std::string& text) {
  char digits[65];
  std::snprintf(digits, sizeof digits, "%064zx", std::hash<std::string>()(text));
  return digits;
}

std::optional<Obstacle> calibrate(Request& request) {
  if (setting("STAND_IN_BROKEN", "") == request.exercise.name) {
    return Obstacle{"the grader gives its own solution COMPILE_ERROR:\ng++: no cc1plus"};
  }
  // 2 (1.4 + 3 x 2 x 0.1) = 4 s for each submission.
  request.compile_limits.wall = 1.4;
  request.run_limits.wall = 0.1;
  return {};
}

void check_memory(const Request&, Report&) {}

void make_ready() {}

void list_level() {}

int play_level(const Command&) {
  return Exit::graded;
}

int play_own(const Command&) {
  return Exit::graded;
}

Report grade_submission(const Request& request, const SoFar& so_far) {
  Report report = blank_report(request);
  const Submission taken =
      read_submission(request.submission, request.exercise.chapter(), request.exercise.header());
  report.unreadable = taken.unreadable;
  std::ofstream(setting("STAND_IN_LOG", "/dev/null"), std::ios::app)
      << request.submission.filename().string() << " " << request.exercise.name << "\n";
  if (!taken.refused.empty()) {
    report.verdict = Verdict::rejected;
    report.why = taken.refused;
    return report;
  }
  report.sha256 = sha256(taken.text);
  report.ignored = taken.ignored;
  if (so_far) so_far(report);
  decide(taken.text, report, so_far);
  return report;
}

}  // namespace grade
