// SPDX-License-Identifier: MIT-0
#include "class/write_tables.h"

#include <algorithm>
#include <cstdio>
#include <functional>

#include "exit_codes.h"
#include "format_values.h"
#include "printable.h"
#include "report/files.h"
#include "report/words.h"

namespace grade {
namespace {

int refuse_stale(const std::vector<Job>& jobs) {
  for (const Job& job : jobs) {
    std::fprintf(stderr, "grade: %s is by another grader or with another seed\n",
                 printable_name((job.out / "report.json").string()).c_str());
  }
  return refuse(Exit::try_again,
                "no tables, since they would mix graders; the same command again "
                "grades these anew");
}

}  // namespace

int write_tables(const ClassList& list, const std::vector<Exercise>& exercises,
                 const std::vector<Job>& jobs, const Class& work) {
  const Results results = collect(list.students, exercises, jobs);
  const std::vector<Job> old = stale(jobs, results, work.seed);
  if (!old.empty()) return refuse_stale(old);
  const std::filesystem::path tables = work.tables();
  std::filesystem::create_directories(tables);
  if (work.round.empty()) write_whole(tables / "grades.csv", grades_csv(results));
  write_whole(tables / "report.csv", report_csv(results));
  write_whole(tables / "summary.html",
              summary_html(results, work.round.empty() ? "Grades of a class" : work.round));
  const std::vector<Report> reports = results.all();
  const auto failed = std::ranges::count_if(reports, std::not_fn(is_graded));
  std::printf("%s, %s: see %s\n", counted(list.students.size(), "student").c_str(),
              counted(exercises.size(), "exercise").c_str(),
              printable_name((tables / "summary.html").string()).c_str());
  if (failed > 0) {
    std::fprintf(stderr,
                 "grade: %s without a grade, since the grader failed; the same command again "
                 "tries them again\n",
                 counted(static_cast<std::size_t>(failed), "submission").c_str());
  }
  return exit_code(reports);
}

}  // namespace grade
