// SPDX-License-Identifier: MIT-0
// What the page calls: an exercise's name goes in, and a report in the grader's words comes back as
// JSON.
#include "page/module.h"

#include <string>

#include "grade_submission.h"
#include "judge/ending.h"
#include "judge/session.h"
#include "judged.h"
#include "page/program.h"
#include "report/words_as_json.h"

/// @param json  a report, see words_as_json.h
extern "C" [[clang::import_module("page"), clang::import_name("so_far")]] void page_so_far(
    const char* json, std::size_t length);

namespace {

constexpr const char* longest = "ten seconds";  // PATIENCE in judge-module.js
std::string text;                               // that goes in and comes out

// Of the session as it is now: the tests that it has not come to have not run.
std::string report_of_session() {
  const judge::Session& session = judge::session();
  grade::Judged judged{session.ended, session.why, session.tests};
  const std::vector<grade::TestResult> all = judge::tests_of(session.exercise);
  for (std::size_t n = judged.tests.size(); n < all.size(); ++n) judged.tests.push_back(all[n]);
  if (!session.stopped()) judged.verdict = grade::verdict(judged);
  grade::Report report;
  report.exercise = session.exercise;
  report.verdict = judged.verdict;
  report.why = judged.why;
  report.tests = judged.tests;
  report.score = judged.score();
  for (const grade::TestResult& test : all) report.points += test.points;
  return grade::words_as_json(report);
}

}  // namespace

// What would be said is tried on the session itself, and taken back.
void page::tell_so_far() {
  if (judge::session().stopped()) return;
  judge::note_too_long(longest);
  const std::string json = report_of_session();
  judge::session().ended = grade::Verdict::accepted;
  judge::session().why.clear();
  page_so_far(json.data(), json.size());
}

/// Room for an exercise's name of so many letters.
extern "C" [[clang::export_name("room")]] char* room(std::size_t length) {
  text.resize(length);
  return text.data();
}

/// Judges the student's module by the tests of the exercise whose name is in the room.
/// @returns how many letters the report has, which are in the room then
extern "C" [[clang::export_name("judge")]] std::size_t judge_module(std::uint32_t seed) {
  judge::Session& session = judge::session();
  session = {};
  session.begin = page::begin_program;
  session.seed = seed;
  judge::run_tests(text);
  text = report_of_session();
  return text.size();
}

extern "C" [[clang::export_name("report")]] const char* report() {
  return text.data();
}
