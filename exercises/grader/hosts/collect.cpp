// SPDX-License-Identifier: MIT-0
#include "hosts/collect.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstdio>
#include <iterator>

#include "class/print_some.h"
#include "command_line.h"
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

constexpr const char* table_of_times = "times.csv";

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
  const auto times = times_in_worksheet(work.worksheet);
  for (HandedFile& one : haul.files) {
    const auto parts = moodle_name(one.student);
    const auto found = times.find(parts ? parts->number : "");
    if (found != times.end()) one.handed_in = found->second;
  }
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

Haul git(const Collection& work) {
  if (work.until.empty()) return from_git(work.from, std::nullopt);
  return from_git(work.from, instant_given(work.until));
}

Haul folders(const Collection& work) {
  return from_folders(work.from);
}

struct Kind {
  const char* name;
  Haul (*read)(const Collection& work);
  bool takes_until, takes_worksheet;
};

constexpr Kind kinds[] = {{"moodle", moodle, false, true},
                          {"canvas", canvas, true, false},
                          {"git", git, true, false},
                          {"folders", folders, false, false}};

const Kind& kind_of(const Collection& work) {
  const auto found =
      std::ranges::find_if(kinds, [&](const Kind& one) { return one.name == work.kind; });
  if (found == std::end(kinds))
    throw Usage("grade collect knows moodle, canvas, git and folders, not '" +
                printable_name(work.kind) + "'");
  if (!work.until.empty() && !found->takes_until) throw Usage("--until is for git and canvas");
  if (!work.worksheet.empty() && !found->takes_worksheet)
    throw Usage("--worksheet is Moodle's, for grade collect moodle");
  return *found;
}

/// The folder in which the submissions' folder lies.
std::filesystem::path beside(const std::filesystem::path& to) {
  const std::filesystem::path tidy = to.has_filename() ? to : to.parent_path();
  return tidy.parent_path();
}

std::vector<std::string> empty_handed(const Haul& haul) {
  std::vector<std::string> names;
  for (const std::string& student : haul.students)
    if (std::ranges::find(haul.files, student, &HandedFile::student) == haul.files.end())
      names.push_back(student);
  return names;
}

void say_what_of_times(const Haul& haul, const std::filesystem::path& table, bool written) {
  const std::string shown = printable_name(table.string());
  const auto unknown = std::ranges::count_if(
      haul.files, [](const HandedFile& one) { return one.handed_in.empty(); });
  if (!written) {
    std::printf(
        "Nothing here says when it was handed in; the files keep the times that they came with\n");
  } else if (unknown > 0) {
    std::printf("%s: fill in the times of %s\n", shown.c_str(),
                counted(std::size_t(unknown), "file").c_str());
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
  const std::filesystem::path table = beside(work.to) / table_of_times;
  check_is_ours(table);
  const std::vector<std::string> others = store(haul, work.to);
  const bool written = write_times(haul, table);
  print_some("Note", haul.notes);
  print_some("Late", {haul.late.begin(), haul.late.end()});
  print_some("Nothing taken of", empty_handed(haul));
  print_some("Still there from before", others);
  say_what_of_times(haul, table, written);
  std::printf("%s of %s, in %s\n", counted(haul.files.size(), "file").c_str(),
              counted(haul.students.size(), "student").c_str(),
              printable_name(work.to.string()).c_str());
  return Exit::graded;
}

}  // namespace grade
