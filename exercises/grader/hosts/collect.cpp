// SPDX-License-Identifier: MIT-0
#include "hosts/collect.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <set>
#include <utility>

#include "class/print_some.h"
#include "command_line.h"
#include "course/course.h"
#include "exit_codes.h"
#include "format_values.h"
#include "given_files.h"
#include "hosts/from.h"
#include "hosts/moodle_name.h"
#include "hosts/moodle_worksheet.h"
#include "hosts/store.h"
#include "hosts/times.h"
#include "printable.h"

namespace grade {
namespace {

Instant instant_given(const std::string& text) {
  const auto time = time_from(text);
  if (!time || !time->offset)
    throw Usage("--until takes a time with its offset, such as 2027-02-08T23:59:00+01:00, not '" +
                printable_name(text) + "'");
  return Instant(time->local.time_since_epoch() - *time->offset);
}

Haul moodle(const Collection& work) {
  Haul haul = from_moodle(work.from);
  if (work.worksheet.empty()) return haul;
  const MoodleWorksheet sheet(work.worksheet);
  const auto times = times_in(sheet, printable_name(work.worksheet.string()));
  const auto people = people_in(sheet);
  const auto number = [](const std::string& folder) {
    const auto parts = moodle_name(folder);
    return parts ? parts->number : "";
  };
  for (HandedFile& one : haul.files)
    if (const auto found = times.find(number(one.student)); found != times.end())
      one.handed_in = found->second;
  for (const std::string& folder : haul.students)
    if (const auto found = people.find(number(folder)); found != people.end())
      haul.people[folder] = found->second;
  return haul;
}

/// Canvas's archive says who was late, and of nobody when.
Haul canvas(const Collection& work) {
  Haul haul = from_canvas(work.from);
  if (work.until.empty()) return haul;
  const std::string in_time = as_written(instant_given(work.until));
  for (HandedFile& one : haul.files)
    if (!haul.late.contains(one.student)) one.handed_in = in_time;
  return haul;
}

/// By one time for all, or by each student's own end of a round and the days after it that count.
Until until_of(const Collection& work) {
  if (work.course.empty() != work.round.empty())
    throw Usage("--course and --round belong together: a round of a course");
  if (!work.course.empty() && !work.until.empty())
    throw Usage("--until is one time for all; the course has each student's own");
  if (!work.until.empty())
    return [end = instant_given(work.until)](const std::string&) { return std::optional(end); };
  if (work.course.empty()) return [](const std::string&) { return std::optional<Instant>(); };
  const Course course = read_course(work.course);
  const Assignment round = assignment_named(course, work.round);
  return [=](const std::string& student) { return last_moment(course, round, student); };
}

Haul git(const Collection& work) {
  return from_git(work.from, until_of(work));
}

Haul folders(const Collection& work) {
  Haul haul = from_folders(work.from);
  haul.bears_times = true;
  return haul;
}

struct Kind {
  const char* name;
  Haul (*read)(const Collection& work);
  bool takes_until, takes_worksheet, takes_course;
};

constexpr Kind kinds[] = {{"moodle", moodle, false, true, false},
                          {"canvas", canvas, true, false, false},
                          {"git", git, true, false, true},
                          {"folders", folders, false, false, false}};

const Kind& kind_of(const Collection& work) {
  const auto found =
      std::ranges::find_if(kinds, [&](const Kind& one) { return one.name == work.kind; });
  if (found == std::end(kinds))
    throw Usage("grade collect knows moodle, canvas, git and folders, not '" +
                printable_name(work.kind) + "'");
  if (!work.until.empty() && !found->takes_until) throw Usage("--until is for git and canvas");
  if (!work.worksheet.empty() && !found->takes_worksheet)
    throw Usage("--worksheet is Moodle's, for grade collect moodle");
  if (!(work.course.empty() && work.round.empty()) && !found->takes_course)
    throw Usage("--course and --round are for grade collect git");
  return *found;
}

std::vector<std::string> empty_handed(const Haul& haul) {
  std::vector<std::string> names;
  for (const std::string& student : haul.students)
    if (std::ranges::find(haul.files, student, &HandedFile::student) == haul.files.end())
      names.push_back(student);
  return names;
}

void say_what_of_times(const std::filesystem::path& table, std::size_t unknown) {
  const std::string shown = printable_name(table.string());
  if (unknown > 0) {
    std::printf("%s: fill in the times of %s\n", shown.c_str(), counted(unknown, "file").c_str());
  } else {
    std::printf("The times are in %s\n", shown.c_str());
  }
}

}  // namespace

int collect_submissions(const Collection& work) {
  const Kind& kind = kind_of(work);
  if (lies_within(work.to, work.from) || lies_within(work.from, work.to))
    throw Usage("the folder of submissions and what is collected may not lie in each other");
  umask(077);  // others' work
  Haul haul = kind.read(work);
  leave_one_each(haul);
  print_some("Not taken", haul.not_taken);
  if (haul.students.empty())
    return refuse(Exit::unreadable, "there is nothing in '" + printable_name(work.from.string()) +
                                        "' that was handed in by way of " + kind.name);
  const std::filesystem::path table = work.to / times_table, people = work.to / people_table;
  check_are_ours(table, people);
  // Before the new files take the place of the old ones.
  std::set<std::pair<std::string, std::string>> same;
  if (!haul.bears_times) same = unchanged(haul, work.to);
  const std::vector<std::string> others = store(haul, work.to);
  std::size_t unknown = 0;
  if (!haul.bears_times)
    unknown = write_times(haul, table, [&](const HandedFile& one) {
      return same.contains({one.student, one.place});
    });
  write_people(haul, people);
  print_some("Note", haul.notes);
  print_some("Late", {haul.late.begin(), haul.late.end()});
  print_some("Nothing taken of", empty_handed(haul));
  print_some("Still there from before", others);
  if (haul.bears_times) {
    std::printf("The times of the files count as those of handing in\n");
  } else {
    say_what_of_times(table, unknown);
  }
  std::printf("%s of %s, in %s\n", counted(haul.files.size(), "file").c_str(),
              counted(haul.students.size(), "student").c_str(),
              printable_name(work.to.string()).c_str());
  return Exit::graded;
}

}  // namespace grade
