// SPDX-License-Identifier: MIT-0
#include "course/grade_course.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstdio>

#include "class/lock.h"
#include "command_line.h"
#include "course/course.h"
#include "course/marks.h"
#include "course/round.h"
#include "exit_codes.h"
#include "format_values.h"
#include "nearest.h"
#include "printable.h"
#include "report/files.h"

namespace grade {
namespace {

constexpr const char* table_of_all = "grades.csv";

void check_extensions(const Course& course, const std::vector<Member>& roster) {
  std::vector<std::string> keys;
  for (const Member& one : roster) keys.push_back(one.key);
  for (const Extension& one : course.extensions) {
    if (std::ranges::find(keys, one.student) != keys.end()) continue;
    const std::string near = nearest(one.student, keys);
    throw Usage(one.place + ": '" + printable_name(one.student) + "' is not on the roster" +
                (near.empty() ? "; write a student as its column of keys does"
                              : "; did you mean '" + printable_name(near) + "'?"));
  }
}

/// Without a name, those that have opened.
std::vector<Assignment> rounds(const Course& course, const std::string& named) {
  if (!named.empty()) return {assignment_named(course, named)};
  std::vector<Assignment> opened;
  for (const Assignment& one : course.assignments) {
    if (!one.opens || *one.opens <= now()) {
      opened.push_back(one);
    } else {
      std::printf("%s opens on %s\n", one.name.c_str(),
                  shown(course.zone.local(*one.opens)).c_str());
    }
  }
  return opened;
}

/// A folder in which a class was graded by itself, or no grader has been, holds tables that would
/// be lost.
/// @throws Usage
void refuse_foreign_results(const std::filesystem::path& results) {
  const auto refuse_table = [&](const char* name) {
    throw Usage("'" + printable_name(results.string()) + "' holds a " + name +
                " that is of no course; name another folder as 'results'");
  };
  if (no_folder(results)) throw NotOwn(results);
  for (const char* of_a_class : {"report.csv", "summary.html"})
    if (std::filesystem::exists(results / of_a_class)) refuse_table(of_a_class);
  if (no_file(results / table_of_all)) throw NotOwn(results / table_of_all);
  const bool new_here = !std::filesystem::exists(Lock::file_in(results));
  if (new_here && std::filesystem::exists(results / table_of_all)) refuse_table(table_of_all);
}

/// What was kept of all assignments, whenever they were graded.
std::vector<Marks> kept_marks(const Course& course) {
  std::vector<Marks> all;
  for (const Assignment& one : course.assignments) {
    const auto text = read_whole(marks_file(course, one));
    if (auto marks = text ? marks_from(*text) : std::nullopt) all.push_back(std::move(*marks));
  }
  return all;
}

int worse(int one, int other) {
  return one == Exit::failed || other == Exit::graded ? one : other;
}

}  // namespace

int grade_course(const CourseWork& work) {
  const Course course = read_course(work.file);
  std::optional<std::vector<Member>> roster;
  if (!course.roster.empty()) roster = read_roster(course.roster, course.key);
  if (roster) check_extensions(course, *roster);
  const std::vector<Assignment> chosen = rounds(course, work.round);
  refuse_foreign_results(course.results);
  umask(077);
  const bool is_part = work.shard.of > 1;
  const Lock lock(course.results, is_part);
  if (!lock.held()) {
    return refuse(Exit::try_again, "another grader is at work in '" +
                                       printable_name(course.results.string()) + "'; wait for it");
  }
  int code = Exit::graded;
  for (const Assignment& one : chosen) {
    const int ended = grade_round(course, one, roster, work);
    if (ended == Exit::unreadable) return ended;
    code = worse(code, ended);
  }
  const std::vector<Marks> marks = kept_marks(course);
  if (marks.empty() || is_part) return code;
  write_whole(course.results / table_of_all,
              grades_of_course(marks, roster.value_or(std::vector<Member>())));
  std::printf("%s: see %s\n", counted(marks.size(), "assignment").c_str(),
              printable_name((course.results / table_of_all).string()).c_str());
  return code;
}

}  // namespace grade
