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

const std::vector<std::string> heads{"student", "exercise", "time"};

/// By student and exercise.
using Rows = std::map<std::pair<std::string, std::string>, std::string>;

Rows rows_of(const std::filesystem::path& table) {
  Rows rows;
  if (no_file(table)) throw NotOwn(table);
  if (!std::filesystem::exists(table)) return rows;
  const std::vector<CsvRow> lines = csv_file(table);
  if (lines.empty() || lines[0].cells != heads)
    throw Usage("'" + printable_name(table.string()) +
                "' is no table of times that was collected; move it away");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    std::vector<std::string> cells = lines[i].cells;
    cells.resize(heads.size());
    rows[{cells[0], cells[1]}] = cells[2];
  }
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

void check_is_ours(const std::filesystem::path& table) {
  rows_of(table);
}

bool write_times(const Haul& haul, const std::filesystem::path& table) {
  const bool any =
      std::ranges::any_of(haul.files, [](const HandedFile& one) { return !one.handed_in.empty(); });
  if (!any) return false;
  Rows rows = rows_of(table);
  for (const HandedFile& one : haul.files) {
    const auto exercise = exercise_at(one.place);
    // A line end in a name would be a line of the table. Whoever is not in it is asked for.
    if (exercise && printable_name(one.student) == one.student)
      rows[{one.student, *exercise}] = one.handed_in;
  }
  std::string text = csv_line(heads);
  for (const auto& [of, time] : rows) text += csv_line({of.first, of.second, time});
  write_whole(table, text);
  return true;
}

}  // namespace grade
