// SPDX-License-Identifier: MIT-0
#include "hosts/filled.h"

#include <algorithm>
#include <map>

#include "command_line.h"
#include "csv.h"
#include "given_files.h"
#include "hosts/moodle_name.h"
#include "hosts/moodle_worksheet.h"
#include "nearest.h"
#include "printable.h"

namespace grade {
namespace {

/// Rows by what may name their student. What names two is no name.
class RowsByName {
 public:
  void add(const std::string& name, std::size_t row) {
    if (name.empty()) return;
    const auto [there, is_new] = rows_.try_emplace(name, row);
    if (!is_new && there->second != row) twice_.push_back(name);
  }

  std::optional<std::size_t> find(const std::string& name) const {
    const auto found = rows_.find(name);
    if (found == rows_.end() || std::ranges::find(twice_, name) != twice_.end())
      return std::nullopt;
    return found->second;
  }

 private:
  std::map<std::string, std::size_t> rows_;
  std::vector<std::string> twice_;
};

std::string called(const StudentMarks& student) {
  return student.name.empty() ? student.student : student.name;
}

/// The number in the name of the folder in which it was handed in.
std::string moodle_number(const StudentMarks& student) {
  const auto parts = moodle_name(student.folder);
  return parts ? parts->number : "";
}

/// What a round is out of.
int out_of(const StudentMarks& student) {
  int of = 0;
  for (const Mark& mark : student.marks) of += mark.of;
  return of;
}

/// A mark out of another sum than the system's would be another share of it, and one above it is
/// passed over there.
/// @param most  as the system writes it, with decimals after a point or a comma
void check_most(const std::string& most, const StudentMarks& student, const std::string& where) {
  const auto whole = whole_number(most.substr(0, most.find_first_of(".,")));
  const int of = out_of(student);
  if (!whole || std::uint64_t(of) == *whole) return;
  throw Usage(where + ": the assignment is out of " + printable_name(most) +
              " there, and this round out of " + std::to_string(of) + "; set it to " +
              std::to_string(of) + " in the system, and download the table again");
}

/// The numbers of Moodle's participants are new with each assignment.
void check_is_this_rounds(const MoodleWorksheet& sheet, const CsvRow& row,
                          const StudentMarks& student, const std::string& where) {
  const auto parts = moodle_name(student.folder);
  const std::string name = as_moodle_writes(sheet.name(row).value_or(""));
  if (!parts || name.empty() || name == parts->name) return;
  throw Usage(where + ": participant " + parts->number + " is '" + printable_name(name) +
              "' here, and '" + printable_name(parts->name) +
              "' in this round; download the worksheet of its assignment");
}

std::size_t column_of_gradebook(const CsvRow& head, const std::string& column,
                                const std::string& file) {
  const auto found = std::ranges::find(head.cells, column);
  if (found != head.cells.end()) return std::size_t(found - head.cells.begin());
  const auto begins = std::ranges::find_if(
      head.cells, [&](const std::string& one) { return one.starts_with(column + " ("); });
  const std::string near = begins != head.cells.end() ? *begins : nearest(column, head.cells);
  throw Usage(file + ":1: there is no column '" + printable_name(column) + "'" +
              (near.empty() ? "; name the assignment's as it stands there, with its number"
                            : "; did you mean '" + printable_name(near) + "'?"));
}

/// A row that is some student's: not the one of what could be had, nor of what is hidden.
std::vector<std::string> names_in_gradebook(const CsvRow& head, const CsvRow& row) {
  std::vector<std::string> names;
  for (const char* column : {"ID", "SIS Login ID", "SIS User ID", "Student"})
    for (std::size_t i = 0; i < std::min(head.cells.size(), row.cells.size()); ++i)
      if (head.cells[i] == column) names.push_back(trimmed(row.cells[i]));
  const bool nobody = names.empty() || names[0].empty();
  return nobody ? std::vector<std::string>() : names;
}

/// Canvas's row of what could be had; null if there is none.
const CsvRow* row_of_most(const CsvRow& head, const std::vector<CsvRow>& rows) {
  const auto column = std::ranges::find(head.cells, "Student") - head.cells.begin();
  const auto found = std::ranges::find_if(rows, [&](const CsvRow& row) {
    return std::size_t(column) < row.cells.size() &&
           trimmed(row.cells[std::size_t(column)]) == "Points Possible";
  });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

std::optional<int> sum_of(const StudentMarks& student) {
  int sum = 0;
  for (const Mark& mark : student.marks) {
    if (!mark.asked || !mark.points) return std::nullopt;
    sum += *mark.points;
  }
  return sum;
}

std::string comment_on(const StudentMarks& student) {
  std::string text;
  for (const Mark& mark : student.marks) {
    if (!text.empty()) text += " ";
    text += mark.exercise + ": " + std::to_string(mark.points.value_or(0)) + " of " +
            std::to_string(mark.of) + ".";
    const bool nothing = mark.verdict.empty() || mark.verdict == "REJECTED";
    if (nothing && mark.handed_in.empty()) text += " Not handed in.";
    if (!mark.late.empty()) text += " " + mark.late;
  }
  return text;
}

Filled filled_worksheet(const Marks& marks, const std::filesystem::path& file) {
  const MoodleWorksheet sheet(file);
  RowsByName numbers, addresses, names;
  for (std::size_t i = 0; i < sheet.rows().size(); ++i) {
    numbers.add(sheet.number(sheet.rows()[i]), i);
    addresses.add(sheet.email(sheet.rows()[i]).value_or(""), i);
    names.add(sheet.name(sheet.rows()[i]).value_or(""), i);
  }
  Filled filled;
  CsvChanges changes(sheet.text());
  for (const StudentMarks& one : marks.students) {
    const std::string number = moodle_number(one);
    auto at = numbers.find(number);
    if (!at && number.empty()) at = addresses.find(one.student);
    if (!at && number.empty()) at = names.find(one.name);
    const auto sum = sum_of(one);
    if (!sum) {
      filled.no_mark.push_back(called(one));
    } else if (!at) {
      filled.nowhere.push_back(called(one));
    } else {
      const CsvRow& row = sheet.rows()[*at];
      const std::string where = printable_name(file.string()) + ":" + std::to_string(row.line);
      check_is_this_rounds(sheet, row, one, where);
      check_most(sheet.most(row).value_or(""), one, where);
      changes.set(row, sheet.grade_column(), std::to_string(*sum));
      if (sheet.comment_column()) changes.set(row, *sheet.comment_column(), comment_on(one));
      ++filled.students;
    }
  }
  filled.text = changes.text();
  return filled;
}

Filled filled_gradebook(const Marks& marks, const std::filesystem::path& file,
                        const std::string& column) {
  const std::string shown = printable_name(file.string());
  const std::string text = table_in(file);
  const std::vector<CsvRow> rows = csv_rows(text, shown);
  const CsvRow head = rows.empty() ? CsvRow() : rows[0];
  if (std::ranges::find(head.cells, "ID") == head.cells.end())
    throw Usage(shown + ":1: Canvas's gradebook has a column ID; export it there, and in English");
  const std::size_t at = column_of_gradebook(head, column, shown);
  RowsByName names;
  for (std::size_t i = 1; i < rows.size(); ++i)
    for (const std::string& name : names_in_gradebook(head, rows[i])) names.add(name, i);
  const CsvRow* const possible = row_of_most(head, rows);
  Filled filled;
  CsvChanges changes(text);
  if (possible && at < possible->cells.size() && !marks.students.empty())
    check_most(trimmed(possible->cells[at]), marks.students.front(),
               shown + ":" + std::to_string(possible->line));
  for (const StudentMarks& one : marks.students) {
    const auto sum = sum_of(one);
    auto found = names.find(one.student);
    if (!found) found = names.find(one.name);
    if (!sum) {
      filled.no_mark.push_back(called(one));
    } else if (!found || at >= rows[*found].cells.size()) {
      filled.nowhere.push_back(called(one));
    } else {
      changes.set(rows[*found], at, std::to_string(*sum));
      ++filled.students;
    }
  }
  filled.text = changes.text();
  return filled;
}

}  // namespace grade
