// SPDX-License-Identifier: MIT-0
#include "frames/log.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace frames {

namespace {

/// Whatever takes longer is a mistake in the unit [s].
constexpr double longest = 60;

/// Rows before the names of the columns, at most.
constexpr std::size_t longest_preamble = 100;

/// A row of a log, and its number, from 1.
struct Row {
  std::size_t number;
  std::vector<std::string> cells;
};

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
  throw std::runtime_error(name + ": " + why);
}

[[noreturn]] void refuse(const std::string& name, const Row& row, const std::string& why) {
  throw std::runtime_error(name + ", row " + std::to_string(row.number) + ": " + why);
}

/// Without blanks and quotes at both ends.
std::string trimmed(std::string_view cell) {
  constexpr std::string_view around = " \t\r\"";
  const auto first = cell.find_first_not_of(around);
  if (first == cell.npos) return "";
  return std::string(cell.substr(first, cell.find_last_not_of(around) - first + 1));
}

/// The rows that hold something.
std::vector<Row> rows_of(const std::string& text) {
  std::vector<Row> rows;
  std::istringstream lines(text);
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (trimmed(line).empty()) continue;
    Row row{number, {}};
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.cells.push_back(trimmed(cell));
    rows.push_back(row);
  }
  return rows;
}

std::optional<double> number_in(const std::string& cell) {
  double value = 0;
  const auto [end, failed] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (failed != std::errc() || end != cell.data() + cell.size()) return {};
  return value;
}

/// Where a column is, by its name in any case; none if it is not there.
std::optional<std::size_t> column(const Row& names, std::string_view name) {
  for (std::size_t n = 0; n < names.cells.size(); ++n) {
    const std::string& cell = names.cells[n];
    const auto same = [](char a, char b) { return std::tolower(a) == std::tolower(b); };
    if (std::equal(cell.begin(), cell.end(), name.begin(), name.end(), same)) return n;
  }
  return {};
}

/// The number in a column of a row.
double number_at(const std::string& name, const Row& row, std::size_t at) {
  if (at >= row.cells.size()) refuse(name, row, "it has too few columns");
  const auto value = number_in(row.cells[at]);
  if (!value) refuse(name, row, "'" + row.cells[at] + "' is no number");
  return *value;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// What frames can take.
bool is_possible(double seconds) {
  return seconds > 0 && seconds <= longest;
}

/// Two frames at least, all of a length that frames can have.
/// @param rows  that they stand in
/// @param unit  of the numbers [s]
std::vector<double> lengths(const std::string& name, const std::vector<Row>& rows, std::size_t at,
                            double unit) {
  std::vector<double> all;
  for (const Row& row : rows) {
    // PresentMon doesn't know how long the first frame took, nor one that it lost sight of.
    if (at < row.cells.size() && row.cells[at] == "NA") continue;
    const double seconds = unit * number_at(name, row, at);
    if (seconds == 0 && all.empty()) continue;
    if (!is_possible(seconds)) {
      refuse(name, row,
             "'" + row.cells[at] + "' is no length of a frame, which lies above 0 and " +
                 "not above a minute");
    }
    all.push_back(seconds);
  }
  if (all.size() < 2) refuse(name, "it has fewer than two frames");
  return all;
}

/// A column of seconds, without a name.
std::vector<double> read_seconds(const std::string& name, const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    if (row.cells.size() > 1)
      refuse(name, row, "it has more columns than the first row, which has no names");
  }
  const std::vector<double> all = lengths(name, rows, 0, 1);
  if (median(all) > 1) {
    refuse(name,
           "half of its frames are longer than a second; a column without a name is in "
           "seconds, and these may be milliseconds");
  }
  return all;
}

/// All rows have to be of one program.
void require_one_program(const std::string& name, const Row& names, const std::vector<Row>& rows) {
  const auto at = column(names, "Application");
  if (!at || rows.empty()) return;
  const auto program = [&](const Row& row) { return *at < row.cells.size() ? row.cells[*at] : ""; };
  for (const Row& row : rows) {
    if (program(row) == program(rows.front())) continue;
    refuse(name, row,
           "it is of " + program(row) + ", and those before are of " + program(rows.front()) +
               "; keep the rows of one program");
  }
}

/// The unit of MangoHud's `frametime` [s]: older versions count microseconds.
double mangohud_unit(const std::string& name, const std::vector<Row>& rows, std::size_t fps,
                     std::size_t frametime) {
  std::vector<double> product;
  for (const Row& row : rows)
    product.push_back(number_at(name, row, fps) * number_at(name, row, frametime));
  if (product.empty()) refuse(name, "it has fewer than two frames");
  const double units = median(product);  // in a second
  if (units > 300 && units < 3000) return 1e-3;
  if (units > 3e5 && units < 3e6) return 1e-6;
  refuse(name, "fps times frametime is neither a second in milliseconds nor one in microseconds");
}

/// MangoHud writes a row for each frame only if it is asked to.
void require_every_frame(const std::string& name, const Row& names, const std::vector<Row>& rows,
                         const std::vector<double>& all) {
  const auto elapsed = column(names, "elapsed");
  if (!elapsed) return;
  const double span =
      1e-9 * (number_at(name, rows.back(), *elapsed) - number_at(name, rows.front(), *elapsed));
  if (std::accumulate(all.begin() + 1, all.end(), 0.0) > 0.8 * span) return;
  refuse(name,
         "its frames take less than four fifths of the time that went by between its rows; "
         "let MangoHud log each frame, with log_interval=0");
}

std::vector<double> read_mangohud(const std::string& name, const Row& names,
                                  const std::vector<Row>& rows, std::size_t fps,
                                  std::size_t frametime) {
  const double unit = mangohud_unit(name, rows, fps, frametime);
  const std::vector<double> all = lengths(name, rows, frametime, unit);
  require_every_frame(name, names, rows, all);
  return all;
}

/// The frames of all runs of CapFrameX's own files.
std::vector<double> read_json(const std::string& name, const std::string& text) {
  std::vector<double> all;
  try {
    const auto runs = nlohmann::json::parse(text).at("Runs");
    for (const auto& run : runs) {
      for (const double milliseconds : run.at("CaptureData").at("MsBetweenPresents")) {
        const double seconds = 1e-3 * milliseconds;
        if (seconds == 0 && all.empty()) continue;
        if (!is_possible(seconds)) {
          refuse(name, "frame " + std::to_string(all.size() + 1) + " takes " +
                           std::to_string(milliseconds) + " ms, which no frame does");
        }
        all.push_back(seconds);
      }
    }
  } catch (const nlohmann::json::exception&) {
    refuse(name, "it is not of CapFrameX, which has Runs with CaptureData and MsBetweenPresents");
  }
  if (all.size() < 2) refuse(name, "it has fewer than two frames");
  return all;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) refuse(file.string(), "there is no such file");
  std::string text(std::istreambuf_iterator<char>(in), {});
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);  // a byte order mark
  return text;
}

}  // namespace

std::vector<double> read_log(const std::filesystem::path& file) {
  const std::string name = file.string(), text = text_of(file);
  if (text.starts_with("{")) return read_json(name, text);
  std::vector<Row> rows = rows_of(text);
  if (rows.empty()) refuse(name, "it is empty");
  if (number_in(rows.front().cells.front())) return read_seconds(name, rows);
  for (std::size_t n = 0; n < std::min(rows.size(), longest_preamble); ++n) {
    const Row names = rows[n];
    const auto after = [&] {
      return std::vector<Row>(rows.begin() + std::ptrdiff_t(n) + 1, rows.end());
    };
    const auto fps = column(names, "fps"), frametime = column(names, "frametime");
    if (fps && frametime) return read_mangohud(name, names, after(), *fps, *frametime);
    for (const char* const known : {"MsBetweenPresents", "FrameTime", "MsBetweenAppStart"}) {
      const auto at = column(names, known);
      if (!at) continue;
      const std::vector<Row> logged = after();
      require_one_program(name, names, logged);
      return lengths(name, logged, *at, 1e-3);
    }
  }
  refuse(name,
         "no row names a column MsBetweenPresents, FrameTime, MsBetweenAppStart, or fps and "
         "frametime, and the first is no number of seconds");
}

}  // namespace frames
