// SPDX-License-Identifier: MIT-0
/// @file
/// Moodle's offline grading worksheet.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "csv.h"
#include "hosts/haul.h"

namespace grade {

/// A worksheet as Moodle wrote it. Its columns are found by their names, English or German ones.
class MoodleWorksheet {
 public:
  /// @throws Usage  it can't be read, or is no worksheet
  explicit MoodleWorksheet(const std::filesystem::path& file);

  const std::vector<CsvRow>& rows() const { return rows_; }  ///< below the head

  /// `4711` of `Participant 4711`; empty if there is none.
  std::string number(const CsvRow& row) const;

  /// A cell, or nothing if the worksheet has no such column.
  std::optional<std::string> name(const CsvRow& row) const { return cell(row, name_); }
  std::optional<std::string> id_number(const CsvRow& row) const { return cell(row, number_); }
  std::optional<std::string> email(const CsvRow& row) const { return cell(row, email_); }
  std::optional<std::string> submitted(const CsvRow& row) const { return cell(row, submitted_); }
  std::optional<std::string> most(const CsvRow& row) const { return cell(row, most_); }

  /// The columns that are filled in.
  std::size_t grade_column() const { return grade_; }
  std::optional<std::size_t> comment_column() const { return comment_; }

  const std::string& text() const { return text_; }

 private:
  std::optional<std::string> cell(const CsvRow& row, std::optional<std::size_t> column) const;

  std::string text_;
  std::vector<CsvRow> rows_;
  std::size_t id_ = 0, grade_ = 0;
  std::optional<std::size_t> name_, number_, email_, submitted_, most_, comment_;
};

/// `Monday, 8 February 2027, 11:59 PM`, as Moodle writes a time in English or German, as
/// `2027-02-08T23:59` on the clocks that Moodle showed it by; nothing if it is written otherwise.
std::optional<std::string> moodle_time(const std::string& text);

/// When each participant handed in, by number.
/// @param name  of the file, for messages
/// @throws Usage  it lacks the column, or a time in it can't be read
std::map<std::string, std::string> times_in(const MoodleWorksheet& sheet, const std::string& name);

/// Who each participant is, by number.
std::map<std::string, Person> people_in(const MoodleWorksheet& sheet);

}  // namespace grade
