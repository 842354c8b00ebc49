// SPDX-License-Identifier: MIT-0
/// @file
/// Tables that others wrote, as RFC 4180 has them and as spreadsheets do.
#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace grade {

/// Where a cell stands in the text, with its quotes.
struct CsvPlace {
  std::size_t begin, size;
};

struct CsvRow {
  std::size_t line = 0;  ///< of the file, on which it begins; from 1
  std::vector<std::string> cells;
  std::vector<CsvPlace> places{};  ///< of these
};

/// The rows of a table that are not empty. Cells are parted by commas, semicolons or tabs, of which
/// the first line has most; lines end in any way; a cell in quotes may hold all of these.
/// @param name  for messages
/// @throws Usage  it is not UTF-8, or a quote is not closed
std::vector<CsvRow> csv_rows(std::string_view text, const std::string& name);

/// The text of a file that holds a table.
/// @throws Usage  it can't be read, or is too long for one that somebody made by hand
std::string table_in(const std::filesystem::path& file);

/// The same of a file.
/// @throws Usage  it can't be read, too
std::vector<CsvRow> csv_file(const std::filesystem::path& file);

/// A line of a table, as a spreadsheet reads it: a cell that starts like a formula has a `'` before
/// it.
std::string csv_line(const std::vector<std::string>& cells);

/// A cell of such a line as it was before it was made safe.
std::string as_was(const std::string& cell);

/// Some cells of a table to be replaced, and all the rest left as it is, byte by byte.
class CsvChanges {
 public:
  /// @param text  of which the rows were read
  explicit CsvChanges(std::string text) : text_(std::move(text)) {}

  void set(const CsvRow& row, std::size_t column, const std::string& cell);

  std::string text() const;

 private:
  std::string text_;
  std::map<std::size_t, std::pair<std::size_t, std::string>> changes_;  ///< by where they begin
};

/// Without spaces at both ends.
std::string trimmed(const std::string& text);

}  // namespace grade
