// SPDX-License-Identifier: MIT-0
#include "class/results.h"
#include "csv.h"
#include "printable.h"
#include "report/words.h"

namespace grade {
namespace {

/// The line that says why: of what a compiler said, the one with the error.
std::string reason(const Report& report) {
  const std::size_t error = report.why.find("error: ");
  const std::size_t before = error == report.why.npos ? error : report.why.rfind('\n', error);
  const std::size_t begin = before == report.why.npos ? 0 : before + 1;
  return report.why.substr(begin, report.why.find('\n', begin) - begin);
}

}  // namespace

std::string grades_csv(const Results& results) {
  std::vector<std::string> head{"student"};
  for (const Exercise& exercise : results.exercises) head.push_back(exercise.name);
  head.insert(head.end(), {"total", "of"});
  std::string text = csv_line(head);
  for (std::size_t s = 0; s < results.students.size(); ++s) {
    std::vector<std::string> cells{printable_name(results.students[s].name)};
    int total = 0, of = 0;
    bool whole = true;
    for (std::size_t e = 0; e < results.exercises.size(); ++e) {
      const Report& report = results.report(s, e);
      const bool asked = results.is_asked(s, e);
      cells.push_back(asked && is_graded(report) ? std::to_string(report.score) : "");
      if (!asked) continue;
      total += report.score;
      of += report.points;
      whole = whole && is_graded(report);
    }
    cells.push_back(whole ? std::to_string(total) : "");
    cells.push_back(whole ? std::to_string(of) : "");
    text += csv_line(cells);
  }
  return text;
}

std::string report_csv(const Results& results) {
  std::string text =
      csv_line({"student", "exercise", "verdict", "score", "points", "seed", "grader", "why"});
  for (std::size_t s = 0; s < results.students.size(); ++s) {
    for (std::size_t e = 0; e < results.exercises.size(); ++e) {
      if (!results.is_asked(s, e)) continue;
      const Report& report = results.report(s, e);
      text += csv_line({printable_name(results.students[s].name), results.exercises[e].name,
                        std::string(name(report.verdict)),
                        is_graded(report) ? std::to_string(report.score) : "",
                        std::to_string(report.points), std::to_string(report.seed), report.version,
                        printable(reason(report))});
    }
  }
  return text;
}

}  // namespace grade
