// SPDX-License-Identifier: MIT-0
#include "class/class.h"

#include <algorithm>
#include <cstdio>

#include "class/grade_all.h"
#include "class/pool.h"
#include "class/write_tables.h"
#include "exit_codes.h"
#include "format_values.h"
#include "report/escape.h"
#include "report/folder.h"

namespace grade {
namespace {

constexpr const char* tables[] = {"grades.csv", "report.csv", "summary.html"};

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
  for (const std::string& file : without_exercise(roll.students, grade::exercises())) {
    std::printf("Belongs to no exercise: %s\n", printable_name(file).c_str());
  }
  const std::vector<Job> all = all_jobs(work, roll.students, exercises);
  std::vector<Job> jobs = part_of(all, work.shard);
  const std::size_t before = jobs.size();
  std::erase_if(jobs, [&](const Job& job) {
    const bool done = is_done(job, work.seed);
    if (done && !work.emits.empty()) emit(kept_report(job), job.out, work.emits);
    return done;
  });
  if (jobs.size() < before) {
    std::printf("%s graded before and skipped\n",
                counted(before - jobs.size(), "submission").c_str());
  }
  if (!jobs.empty()) {
    if (work.seed == Request().seed) {
      std::printf("Graded with the public seed; --seed-file names one that only you know\n");
    }
    if (const auto why = unsafe()) return refuse(Exit::failed, *why);
    if (const auto obstacle = grade_all(jobs, work)) {
      return refuse(obstacle->try_again ? Exit::try_again : Exit::failed,
                    "nobody is graded, since " + obstacle->why);
    }
  }
  if (work.shard.of == 1) return write_tables(roll, exercises, all, work);
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
  try {
    return grade_roll(roll, work);
  } catch (const Interrupted& stopped) {
    return refuse(Exit::try_again, stopped.what());
  }
}

}  // namespace grade
