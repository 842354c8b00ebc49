// SPDX-License-Identifier: MIT-0
#include "hosts/times.h"

#include <algorithm>
#include <map>

#include "command_line.h"
#include "csv.h"
#include "exercise.h"
#include "printable.h"
#include "report/files.h"

namespace grade {
namespace {

const std::vector<std::string> times_heads{"student", "exercise", "time"};
const std::vector<std::string> people_heads{"folder", "name", "id", "email"};

/// The rows of a table that a collection has written; none if it is not there.
/// @throws Usage  it is another one
std::vector<std::vector<std::string>> rows_in(const std::filesystem::path& table,
                                              const std::vector<std::string>& heads,
                                              const char* of) {
  std::vector<std::vector<std::string>> all;
  if (no_file(table)) throw NotOwn(table);
  if (!std::filesystem::exists(table)) return all;
  const std::vector<CsvRow> lines = csv_file(table);
  if (lines.empty() || lines[0].cells != heads)
    throw Usage("'" + printable_name(table.string()) + "' is no table of " + of +
                " that was collected; move it away");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    std::vector<std::string>& cells = all.emplace_back(lines[i].cells);
    cells.resize(heads.size());
    std::ranges::transform(cells, cells.begin(), as_was);
  }
  return all;
}

/// By student and exercise.
using Rows = std::map<std::pair<std::string, std::string>, std::string>;

Rows rows_of(const std::filesystem::path& table) {
  Rows rows;
  for (const auto& cells : rows_in(table, times_heads, "times"))
    rows[{cells[0], cells[1]}] = cells[2];
  return rows;
}

/// The exercise whose header this is; nothing if it is none's.
std::optional<std::string> exercise_at(const std::string& place) {
  for (const Exercise& one : exercises())
    if (place == one.header() || place == one.name + ".h") return one.name;
  return std::nullopt;
}

}  // namespace

std::string as_written(Instant time) {
  std::string text = shown(LocalTime(time.time_since_epoch()));
  std::ranges::replace(text, ' ', 'T');
  return text + "Z";
}

void check_are_ours(const std::filesystem::path& times, const std::filesystem::path& people) {
  rows_of(times);
  people_in(people);
}

std::size_t write_times(const Haul& haul, const std::filesystem::path& table,
                        const std::function<bool(const HandedFile&)>& same) {
  const Rows before = rows_of(table);
  Rows rows = before;
  std::erase_if(rows, [&](const auto& row) { return haul.students.contains(row.first.first); });
  for (const HandedFile& one : haul.files) {
    const auto exercise = exercise_at(one.place);
    // A line end in a name would be a line of the table. Whoever is not in it is asked for.
    if (!exercise || printable_name(one.student) != one.student) continue;
    const auto old = before.find({one.student, *exercise});
    const bool stays = one.handed_in.empty() && old != before.end() && same(one);
    rows[{one.student, *exercise}] = stays ? old->second : one.handed_in;
  }
  std::string text = csv_line(times_heads);
  for (const auto& [of, time] : rows) text += csv_line({of.first, of.second, time});
  write_whole(table, text);
  return std::size_t(
      std::ranges::count_if(rows, [](const auto& row) { return row.second.empty(); }));
}

void write_people(const Haul& haul, const std::filesystem::path& table) {
  std::map<std::string, Person> all = people_in(table);
  for (const auto& [folder, person] : haul.people)
    if (printable_name(folder) == folder) all[folder] = person;
  if (all.empty()) return;
  std::string text = csv_line(people_heads);
  for (const auto& [folder, one] : all) text += csv_line({folder, one.name, one.id, one.email});
  write_whole(table, text);
}

std::map<std::string, Person> people_in(const std::filesystem::path& table) {
  std::map<std::string, Person> all;
  for (const auto& cells : rows_in(table, people_heads, "people"))
    all[cells[0]] = {cells[1], cells[2], cells[3]};
  return all;
}

}  // namespace grade
