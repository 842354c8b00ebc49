// SPDX-License-Identifier: MIT-0
/// @file
/// Keeps what a program found, and writes it where the book finds it.
#pragma once
#include <deque>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace measure {

/// Digits of a count: print all of them.
inline constexpr int whole = 0;

/// One column of a table: its name, its unit, and how many significant digits the book shows.
struct Column {
  std::string name;
  std::string unit = "";
  int digits = 3;  ///< significant digits that the book shows; `whole` for a count
};

/// One cell of a table: a number, or words.
struct Cell {
  double value = 0;
  std::string words = "";  ///< not empty: the cell holds these and no number

  Cell(double number) : value(number) {}
  Cell(std::string text) : words(std::move(text)) {}
  Cell(std::string_view text) : words(text) {}
  Cell(const char* text) : words(text) {}
};

/// A table of measured values.
struct Table {
  std::string name;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;

  /// Adds a row.
  /// @throws std::logic_error  it has not as many cells as the table has columns
  void add(std::vector<Cell> row);
};

/// One measured value that a sentence of the book quotes.
struct Number {
  std::string name;
  double value = 0;
  int digits = 3;  ///< significant digits that the book shows; `whole` for a count
  std::string unit;
};

/// What one program found: numbers for its sentences, tables for its figures.
class Record {
 public:
  /// Keeps a number.
  /// @throws std::logic_error  there is a number of this name
  void number(std::string name, double value, int digits, std::string unit = "");

  /// Starts a table, written as NAME.csv. The reference stays good.
  /// @throws std::logic_error  there is a table of this name
  Table& table(std::string name, std::vector<Column> columns);

  /// Writes numbers.csv, tables.csv and one file for each table.
  ///
  /// Each is written beside its place first, and put there only when all of them are whole.
  ///
  /// @param folder  must exist
  /// @throws std::runtime_error  one line that says which file could not be written, and why
  void write(const std::filesystem::path& folder) const;

  /// Prints the numbers, and what tables there are.
  void print() const;

 private:
  std::vector<Number> numbers_;
  std::deque<Table> tables_;
};

/// The whole of a chapter program's `main`: `program` prints what it found, `program FOLDER` writes
/// it.
///
/// @param argc  from main
/// @param argv  from main
/// @param fill  does the work and keeps what it found
/// @returns 0, or 2 after one line on stderr: for arguments that it doesn't know, a folder that it
///          can't write to, a name recorded twice, a row of the wrong length
int record(int argc, char** argv, const std::function<void(Record&)>& fill);

}  // namespace measure
