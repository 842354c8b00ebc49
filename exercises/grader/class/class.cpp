// SPDX-License-Identifier: MIT-0
#include "class/class.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <system_error>

#include "class/grade_all.h"
#include "class/lock.h"
#include "class/pool.h"
#include "class/print_some.h"
#include "class/write_tables.h"
#include "exit_codes.h"
#include "format_values.h"
#include "printable.h"
#include "report/files.h"
#include "report/folder.h"
#include "submission.h"

namespace grade {
namespace {

constexpr const char* written[] = {"grades.csv", "report.csv", "summary.html"};
constexpr const char* tables[] = {"grades.csv", "report.csv", "summary.html", Class::part_folder,
                                  // of a round of a course
                                  "marks.json", "late.csv", "equal.csv", "pages", "pages.zip",
                                  "moodle.csv", "canvas.csv"};

/// The student whose name is that of a table; null if there is none.
const Student* named_like_a_table(const std::vector<Student>& students) {
  for (const Student& student : students) {
    if (std::ranges::find(tables, student.name) != std::end(tables)) return &student;
  }
  return nullptr;
}

/// The name of something that stands in place of a file or folder of the grader's, or of a table
/// that would be lost in a folder in which no grader has been; empty if there is none.
std::string foreign_file(const Class& work) {
  const std::filesystem::path lock = Lock::file_in(work.results), part = Class::part_folder;
  if (no_file(lock)) return lock.filename();
  if (no_folder(work.results / part)) return part;
  for (const auto& folder : {std::filesystem::path(), part})
    for (const char* table : written)
      if (no_file(work.results / folder / table)) return folder / table;
  if (std::filesystem::exists(lock)) return "";
  for (const char* table : tables)
    if (std::filesystem::exists(work.results / table)) return table;
  return "";
}

/// A link on the way to a submission's report, or in place of one of its files; empty if none is.
std::filesystem::path irregular_path(const Class& work, const Job& job) {
  std::filesystem::path at = work.results;
  for (const auto& name : std::filesystem::path(job.student.name) / job.exercise.name) {
    at /= name;
    if (std::filesystem::is_symlink(std::filesystem::symlink_status(at))) return at;
  }
  const std::string file = irregular_file(at);
  return file.empty() ? "" : at / file;
}

/// A backup of hard links has the same files: what somebody writes there is written here.
void print_linked(const std::vector<Job>& jobs) {
  const auto linked = std::ranges::count_if(jobs, [](const Job& job) {
    return read_submission(job.student.folder, job.exercise.chapter(), job.exercise.header())
        .linked;
  });
  if (linked > 0) {
    std::printf("%s with more than one hard link, as a backup makes them\n",
                counted(static_cast<std::size_t>(linked), "submission").c_str());
  }
}

bool can_be_read_by_others(const std::filesystem::path& file) {
  using std::filesystem::perms;
  std::error_code none;
  const auto found = std::filesystem::status(file, none).permissions();
  return !none && (found & (perms::group_read | perms::others_read)) != perms::none;
}

/// The names of those that are not among the others.
std::vector<std::string> not_among(const std::vector<Exercise>& all,
                                   const std::vector<Exercise>& others) {
  std::vector<std::string> names;
  for (const Exercise& one : all) {
    if (std::ranges::find(others, one.name, &Exercise::name) == others.end())
      names.push_back(one.name);
  }
  return names;
}

int grade_students(const ClassList& list, const Class& work) {
  const std::vector<Exercise> handed = handed_in(list.students, grade::exercises());
  const std::vector<Exercise> exercises = work.partial()          ? work.exercises
                                          : work.assigned.empty() ? handed
                                                                  : work.assigned;
  if (!work.assigned.empty())
    print_some("Handed in, but not assigned", not_among(handed, exercises));
  if (exercises.empty()) {
    return refuse(Exit::unreadable, "nobody handed in an exercise; it should be called STUDENT/" +
                                        grade::exercises().front().name +
                                        ".h or like another that --list names");
  }
  for (const std::string& name : without_exercise(list.students, grade::exercises()))
    std::printf("Belongs to no exercise: %s\n", printable_name(name).c_str());
  const std::vector<Job> all = all_jobs(work, list.students, exercises);
  for (const Job& job : all)
    if (const auto other = irregular_path(work, job); !other.empty()) throw NotOwn(other);
  std::vector<Job> jobs = all;
  std::erase_if(jobs, [](const Job& job) { return !job.asked; });
  const std::vector<Job> part = jobs_of(jobs, work.shard);
  jobs = part;
  print_linked(part);
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
  if (work.shard.of == 1) return write_tables(list, exercises, all, work);
  std::printf("Part %zu of %zu is done; without --shard, the tables are made\n", work.shard.part,
              work.shard.of);
  return exit_code(collect(list.students, exercises, part).all());
}

}  // namespace

int grade_class(const Class& work) {
  ClassList list;
  try {
    list = read_students(work.submissions);
  } catch (const std::filesystem::filesystem_error& error) {
    return refuse(Exit::unreadable, "can't read the folder '" +
                                        printable_name(work.submissions.string()) +
                                        "': " + error.code().message());
  }
  if (work.takes_part) std::erase_if(list.students, std::not_fn(work.takes_part));
  print_some("Not a student's folder", list.ignored);
  if (list.students.empty()) {
    return refuse(Exit::unreadable, "there is no student's folder in '" +
                                        printable_name(work.submissions.string()) + "'");
  }
  if (const Student* student = named_like_a_table(list.students)) {
    return refuse(Exit::bad_input, "a student's folder can't be called " + student->name +
                                       ", since a table is; rename it");
  }
  if (const std::string name = foreign_file(work); !name.empty()) {
    return refuse(Exit::bad_input, "'" + printable_name(work.results.string()) + "' holds a " +
                                       name +
                                       " that is not the grader's own; name another folder "
                                       "with --out");
  }
  umask(077);  // what is written now holds marks, and the seed
  if (can_be_read_by_others(work.seed_file)) {
    std::fprintf(stderr, "grade: others can read the seed; chmod 600 %s\n",
                 printable_name(work.seed_file.string()).c_str());
  }
  const Lock lock(work.results, work.shard.of > 1);
  if (!lock.held()) {
    return refuse(Exit::try_again, "another grader is at work in '" +
                                       printable_name(work.results.string()) +
                                       "'; wait for it, or name another folder");
  }
  try {
    return grade_students(list, work);
  } catch (const Interrupted& stopped) {
    return refuse(Exit::try_again, stopped.what());
  }
}

}  // namespace grade
