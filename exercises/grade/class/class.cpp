// SPDX-License-Identifier: MIT-0
#include "class/class.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include "class/pool.h"
#include "class/progress.h"
#include "class/results.h"
#include "judge/session.h"
#include "one.h"
#include "report/escape.h"
#include "report/files.h"
#include "time_limits.h"

namespace grade {
namespace {

constexpr const char* tables[] = {"grades.csv", "report.csv", "summary.html"};

std::string count(std::size_t number, const std::string& thing) {
  return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

int refuse(int code, const std::string& why) {
  std::fprintf(stderr, "grade: %s\n", why.c_str());
  return code;
}

/// The longest that a grading can take: the compiler, and each test, which starts at most two
/// drivers; as much again for the rest.
std::chrono::milliseconds longest(const Request& request) {
  const auto tests = static_cast<double>(judge::tests_of(request.exercise.name).size());
  const double seconds = request.compile_limits.wall + 2 * tests * request.run_limits.wall;
  return std::chrono::milliseconds(static_cast<long>(2000 * seconds));
}

/// Limits are calibrated once for each exercise, before anything else runs.
std::vector<Task> tasks(const std::vector<Job>& jobs, const Class& work) {
  std::map<std::string, Request> requests;
  std::vector<Task> all;
  for (const Job& job : jobs) {
    const auto [found, is_new] = requests.try_emplace(job.exercise.name);
    Request& request = found->second;
    if (is_new) {
      request.exercise = job.exercise;
      request.seed = work.seed;
      calibrate(request);
    }
    all.push_back({arguments(job, work, write_limits(request)), longest(request)});
  }
  return all;
}

void grade_all(const std::vector<Job>& jobs, const Class& work) {
  Progress progress(jobs.size(), isatty(STDOUT_FILENO) != 0);
  run_all(tasks(jobs, work), work.jobs,
          [&](std::size_t i) { progress.done(jobs[i], kept_report(jobs[i])); });
}

/// What a class comes to: 0, or that the grader failed somewhere.
int exit_code(const std::vector<Report>& reports) {
  int code = Exit::graded;
  for (const Report& report : reports) {
    if (is_graded(report)) continue;
    if (!report.try_again) return Exit::failed;
    code = Exit::try_again;
  }
  return code;
}

int refuse_stale(const std::vector<Job>& jobs) {
  for (const Job& job : jobs) {
    std::fprintf(stderr, "grade: %s is by another grader or with another seed\n",
                 printable_name((job.out / "report.json").string()).c_str());
  }
  return refuse(Exit::try_again,
                "no tables, since they would mix graders; the same command again "
                "grades these anew");
}

int make_tables(const Roll& roll, const std::vector<Exercise>& exercises,
                const std::vector<Job>& jobs, const Class& work) {
  const Results results = collect(roll.students, exercises, jobs);
  const std::vector<Job> old = stale(jobs, results, work.seed);
  if (!old.empty()) return refuse_stale(old);
  write_whole(work.results / "grades.csv", grades_csv(results));
  write_whole(work.results / "report.csv", report_csv(results));
  write_whole(work.results / "summary.html", summary_html(results));
  const auto failed = std::ranges::count_if(results.reports, std::not_fn(is_graded));
  std::printf("%s, %s: see %s\n", count(roll.students.size(), "student").c_str(),
              count(exercises.size(), "exercise").c_str(),
              printable_name((work.results / "summary.html").string()).c_str());
  if (failed > 0) {
    std::fprintf(stderr,
                 "grade: %s without a grade, since the grader failed; the same command again "
                 "tries them again\n",
                 count(static_cast<std::size_t>(failed), "submission").c_str());
  }
  return exit_code(results.reports);
}

/// A student of this name would stand where a table goes.
const Student* in_the_way(const std::vector<Student>& students) {
  for (const Student& student : students) {
    if (std::ranges::find(tables, student.name) != std::end(tables)) return &student;
  }
  return nullptr;
}

int grade_roll(const Roll& roll, const Class& work) {
  const std::vector<Exercise> exercises =
      work.exercises.empty() ? handed_in(roll.students, grade::exercises()) : work.exercises;
  if (exercises.empty()) {
    return refuse(Exit::unreadable, "nobody handed in an exercise; it should be called STUDENT/" +
                                        grade::exercises().front().name +
                                        ".h or like another that --list names");
  }
  const std::vector<Job> all = all_jobs(work, roll.students, exercises);
  std::vector<Job> jobs = part_of(all, work.shard);
  const std::size_t before = jobs.size();
  std::erase_if(jobs, [&](const Job& job) { return is_done(job, work.seed); });
  if (jobs.size() < before) {
    std::printf("%s graded before and skipped\n",
                count(before - jobs.size(), "submission").c_str());
  }
  if (!jobs.empty()) {
    if (work.seed == Request().seed) {
      std::printf("Graded with the public seed; --seed-file names one that only you know\n");
    }
    if (const auto why = unsafe()) return refuse(Exit::failed, *why);
    std::filesystem::create_directories(work.results);
    grade_all(jobs, work);
  }
  if (work.shard.of == 1) return make_tables(roll, exercises, all, work);
  std::printf("Part %zu of %zu is done; without --shard, the tables are made\n", work.shard.part,
              work.shard.of);
  return exit_code(collect(roll.students, exercises, part_of(all, work.shard)).reports);
}

}  // namespace

int grade_class(const Class& work) {
  Roll roll;
  try {
    roll = call_roll(work.submissions);
  } catch (const std::filesystem::filesystem_error& error) {
    return refuse(Exit::unreadable, "can't read the folder '" +
                                        printable_name(work.submissions.string()) +
                                        "': " + error.code().message());
  }
  for (const std::string& name : roll.ignored) {
    std::printf("Not a student's folder: %s\n", printable_name(name).c_str());
  }
  if (roll.students.empty()) {
    return refuse(Exit::unreadable, "there is no student's folder in '" +
                                        printable_name(work.submissions.string()) + "'");
  }
  if (const Student* student = in_the_way(roll.students)) {
    return refuse(Exit::bad_input, "a student's folder can't be called " + student->name +
                                       ", since a table is; rename it");
  }
  return grade_roll(roll, work);
}

}  // namespace grade
