// SPDX-License-Identifier: MIT-0
#include "course/handed_in_at.h"

#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <vector>

#include "command_line.h"
#include "csv.h"
#include "exercise.h"
#include "hosts/store.h"
#include "nearest.h"
#include "printable.h"

namespace grade {
namespace {

/// By student, and exercise or assignment.
using Times = std::map<std::pair<std::string, std::string>, Instant>;

/// A cell under one of these heads.
std::optional<std::string> under(const CsvRow& head, const CsvRow& row, std::string_view column) {
  for (std::size_t i = 0; i < std::min(head.cells.size(), row.cells.size()); ++i)
    if (trimmed(head.cells[i]) == column) return trimmed(row.cells[i]);
  return std::nullopt;
}

/// On clocks that are put back, a time that stands there twice is the earlier one.
Instant instant_in(const std::string& text, const TimeZone& zone, const std::string& where) {
  const auto time = time_from(text);
  if (!time)
    throw Usage(where + "'" + printable_name(text) +
                "' is no time; write it as 2027-02-08T23:59:00, or with Z or +01:00 behind it");
  if (time->offset) return Instant(time->local.time_since_epoch() - *time->offset);
  const auto found = zone.instants(time->local);
  if (found.empty())
    throw Usage(where + "there is no " + shown(time->local) + " in " + zone.name() +
                ", since the clocks are put forward; write it with an offset, such as +01:00");
  return found.front();
}

void check_heads(const CsvRow& head, const std::string& file) {
  const auto has = [&](std::string_view column) { return under(head, head, column).has_value(); };
  if (has("student") && has("time") && (has("exercise") || has("assignment"))) return;
  throw Usage(file + ":" + std::to_string(head.line) +
              ": the columns of such a table are student, exercise or assignment, and time; name "
              "them in its first line");
}

/// An exercise, or an assignment of the course.
void check_is_known(const std::string& of, const Course& course, const std::string& where) {
  std::vector<std::string> known;
  for (const Assignment& one : course.assignments) known.push_back(one.name);
  for (const Exercise& one : exercises()) known.push_back(one.name);
  if (std::ranges::find(known, of) != known.end()) return;
  const std::string near = nearest(of, known);
  throw Usage(where + "there is no exercise and no assignment '" + printable_name(of) +
              "'; did you mean '" + (near.empty() ? nearest_exercise(of) : near) + "'?");
}

Times read_times(const std::filesystem::path& path, const Course& course) {
  const std::string file = printable_name(path.string());
  const std::vector<CsvRow> rows = csv_file(path);
  if (rows.empty()) throw Usage(file + ":1: this table is empty");
  check_heads(rows[0], file);
  Times times;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::string where = file + ":" + std::to_string(rows[i].line) + ": ";
    const std::string student = as_was(under(rows[0], rows[i], "student").value_or(""));
    std::string of = under(rows[0], rows[i], "exercise").value_or("");
    if (of.empty()) of = under(rows[0], rows[i], "assignment").value_or("");
    if (student.empty() || of.empty())
      throw Usage(where +
                  "whose time is this, and of what? Fill in student, and exercise or "
                  "assignment");
    check_is_known(of, course, where);
    const std::string time = under(rows[0], rows[i], "time").value_or("");
    if (time.empty()) continue;
    const Instant at = instant_in(time, course.zone, where);
    const auto [known, is_new] = times.try_emplace({student, of}, at);
    if (!is_new) known->second = std::max(known->second, at);
  }
  return times;
}

std::vector<std::filesystem::path> tables_of(const Course& course, const Assignment& assignment) {
  std::vector<std::filesystem::path> all;
  if (!course.times.empty()) all.push_back(course.times);
  const std::filesystem::path collected = assignment.submissions / times_table;
  if (is_collection(assignment.submissions) && std::filesystem::exists(collected))
    all.push_back(collected);
  return all;
}

}  // namespace

std::optional<Instant> time_of_file(const Participant& student, const Exercise& exercise) {
  if (!student.folder) return std::nullopt;
  const auto& folder = student.folder->folder;
  for (const auto& file :
       {folder / exercise.chapter() / exercise.header(), folder / exercise.header()}) {
    struct stat about{};
    if (::lstat(file.c_str(), &about) == 0)
      return Instant(std::chrono::seconds(about.st_mtim.tv_sec));
  }
  return std::nullopt;
}

HandedInAt times_of(const Course& course, const Assignment& assignment) {
  if (course.times_of_files) return time_of_file;
  std::vector<Times> tables;
  for (const std::filesystem::path& file : tables_of(course, assignment))
    tables.push_back(read_times(file, course));
  if (tables.empty()) return time_of_file;
  return [tables, name = assignment.name](const Participant& student,
                                          const Exercise& exercise) -> std::optional<Instant> {
    const std::string folder = student.folder ? student.folder->name : "";
    for (const Times& times : tables)
      for (const std::string& of : {exercise.name, name})
        for (const std::string& who : {student.member.key, folder})
          if (const auto found = times.find({who, of}); found != times.end()) return found->second;
    return std::nullopt;
  };
}

std::filesystem::path table_of_times(const Course& course, const Assignment& assignment) {
  if (course.times_of_files) return {};
  const auto all = tables_of(course, assignment);
  return all.empty() ? std::filesystem::path() : all.back();
}

}  // namespace grade
