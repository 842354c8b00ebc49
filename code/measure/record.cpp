// SPDX-License-Identifier: MIT-0
#include "measure/record.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <ostream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace measure {
namespace {

using std::filesystem::path;

std::string shortest(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string join(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) line += (&cell == &cells.front() ? "" : ",") + cell;
  return line + "\n";
}

std::string quoted(const std::string& words) {
  return words.find(',') == std::string::npos ? words : '"' + words + '"';
}

std::string text(const Cell& cell) {
  return cell.words.empty() ? shortest(cell.value) : quoted(cell.words);
}

// A word among numbers, such as "rounding", does not make a column one of text.
bool is_text(const Table& table, std::size_t column) {
  const auto is_word = [&](const auto& row) { return !row[column].words.empty(); };
  return !table.rows.empty() && std::all_of(table.rows.begin(), table.rows.end(), is_word);
}

std::string csv(const Table& table) {
  std::vector<std::string> names;
  for (const Column& column : table.columns) names.push_back(quoted(column.name));
  std::string lines = join(names);
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (const Cell& cell : row) cells.push_back(text(cell));
    lines += join(cells);
  }
  return lines;
}

std::runtime_error failure(const path& file, int error) {
  return std::runtime_error("can't write " + file.string() + ": " + std::strerror(error));
}

path part(const path& file) {
  return file.string() + ".part";
}

void write_part(const path& file, const std::string& lines) {
  std::ofstream out(part(file), std::ios::binary);
  out << lines << std::flush;
  if (!out) throw failure(file, errno);
}

void refuse_twice(const auto& kept, const std::string& kind, const std::string& name) {
  for (const auto& one : kept) {
    if (one.name == name)
      throw std::logic_error("the " + kind + " \"" + name + "\" is recorded twice");
  }
}

void put_in_place(const path& file) {
  std::error_code problem;
  std::filesystem::rename(part(file), file, problem);
  if (problem) throw failure(file, problem.value());
}

/// Refuses a folder that won't take what is found, before anything is measured.
void try_folder(const path& folder) {
  const path numbers = folder / "numbers.csv";
  write_part(numbers, "");
  std::filesystem::remove(part(numbers));
  if (is_directory(numbers)) throw failure(numbers, EISDIR);
}

}  // namespace

void Table::add(std::vector<Cell> row) {
  if (row.size() != columns.size()) {
    throw std::logic_error("table \"" + name + "\": a row of " + std::to_string(row.size()) +
                           " cells for " + std::to_string(columns.size()) + " columns");
  }
  rows.push_back(std::move(row));
}

void Record::number(std::string name, double value, int digits, std::string unit) {
  refuse_twice(numbers_, "number", name);
  numbers_.push_back({std::move(name), value, digits, std::move(unit)});
}

Table& Record::table(std::string name, std::vector<Column> columns) {
  refuse_twice(tables_, "table", name);
  return tables_.emplace_back(Table{std::move(name), std::move(columns), {}});
}

void Record::write(const path& folder) const {
  std::map<path, std::string> files;
  std::string& numbers = files[folder / "numbers.csv"] = "name,value,unit,digits\n";
  std::string& columns = files[folder / "tables.csv"] = "table,column,unit,digits\n";
  for (const Number& n : numbers_) {
    numbers += join({n.name, shortest(n.value), n.unit, std::to_string(n.digits)});
  }
  for (const Table& table : tables_) {
    files[folder / (table.name + ".csv")] = csv(table);
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const Column& column = table.columns[i];
      const std::string digits = is_text(table, i) ? "text" : std::to_string(column.digits);
      columns += join({table.name, quoted(column.name), column.unit, digits});
    }
  }
  try {
    for (const auto& [file, lines] : files) write_part(file, lines);
    for (const auto& [file, lines] : files) put_in_place(file);
  } catch (...) {
    std::error_code ignored;
    for (const auto& [file, lines] : files) std::filesystem::remove(part(file), ignored);
    throw;
  }
}

void Record::print() const {
  for (const Number& n : numbers_) {
    const int digits = n.digits == whole ? 15 : n.digits;
    std::printf("%-40s %.*g %s\n", n.name.c_str(), digits, n.value, n.unit.c_str());
  }
  for (const Table& table : tables_) {
    std::printf("table %-34s %zu rows\n", table.name.c_str(), table.rows.size());
  }
}

int record(int argc, char** argv, const std::function<void(Record&)>& fill) {
  const std::string program = path(argv[0]).filename();
  if (argc > 2 || (argc == 2 && argv[1][0] == '-')) {
    std::fprintf(stderr, "%s: don't know '%s'; usage: %s [FOLDER]\n", program.c_str(),
                 argv[argc > 2 ? 2 : 1], program.c_str());
    return 2;
  }
  if (argc == 2 && access((path(argv[1]) / "").c_str(), W_OK | X_OK) != 0) {
    std::fprintf(stderr, "%s: can't write to '%s': %s; name a folder that is yours\n",
                 program.c_str(), argv[1], std::strerror(errno));
    return 2;
  }
  try {
    if (argc == 2) try_folder(argv[1]);
    Record found;
    fill(found);
    if (argc == 1) {
      found.print();
    } else {
      found.write(argv[1]);
    }
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s: %s\n", program.c_str(), problem.what());
    return 2;
  }
  return 0;
}

}  // namespace measure
