// SPDX-License-Identifier: MIT-0
#include "csv.h"

#include <algorithm>

#include "command_line.h"
#include "given_files.h"
#include "printable.h"

namespace grade {
namespace {

/// The separator that the first line has most of, outside of quotes.
char separator_of(std::string_view text) {
  constexpr std::string_view all = ",;\t";
  std::size_t counts[all.size()] = {};
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == '\n' || c == '\r')) break;
    if (const std::size_t which = all.find(c); !quoted && which != all.npos) ++counts[which];
  }
  return all[std::size_t(std::ranges::max_element(counts) - std::begin(counts))];
}

[[noreturn]] void refuse_line(const std::string& name, std::size_t line, const std::string& why) {
  throw Usage(name + ":" + std::to_string(line) + ": " + why);
}

void check_is_text(std::string_view text, const std::string& name) {
  std::size_t line = 1;
  for (std::string_view left = text; !left.empty();) {
    const std::size_t size = utf8_character(left);
    if (size == 0 || left[0] == '\0')
      refuse_line(name, line, "this is not UTF-8; save it as 'CSV UTF-8'");
    line += left[0] == '\n';
    left.remove_prefix(size);
  }
}

/// Reads one table.
class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& name)
      : text_(text), left_(text), name_(name), separator_(separator_of(text)) {}

  std::vector<CsvRow> all() {
    std::vector<CsvRow> rows;
    while (!left_.empty()) {
      CsvRow found = row();
      const bool empty = std::ranges::all_of(
          found.cells, [](const std::string& one) { return trimmed(one).empty(); });
      if (!empty) rows.push_back(std::move(found));
    }
    return rows;
  }

 private:
  char take() {
    const char c = left_[0];
    left_.remove_prefix(1);
    line_ += c == '\n';
    return c;
  }

  CsvRow row() {
    CsvRow row{line_, {}, {}};
    for (bool more = true; more;) {
      const std::size_t begin = text_.size() - left_.size();
      row.cells.push_back(!left_.empty() && left_[0] == '"' ? quoted() : plain());
      row.places.push_back({begin, text_.size() - left_.size() - begin});
      more = !left_.empty() && left_[0] == separator_;
      if (more) take();
    }
    if (!left_.empty() && left_[0] == '\r') take();
    if (!left_.empty() && left_[0] == '\n') take();
    return row;
  }

  std::string plain() {
    std::string text;
    const std::string ends = {separator_, '\r', '\n'};
    while (!left_.empty() && ends.find(left_[0]) == ends.npos) text += take();
    return text;
  }

  std::string quoted() {
    const std::size_t begin = line_;
    take();
    std::string text;
    while (!left_.empty()) {
      const char c = take();
      if (c != '"') {
        text += c;
      } else if (!left_.empty() && left_[0] == '"') {
        text += take();
      } else {
        return text + plain();
      }
    }
    refuse_line(name_, begin, "this quote is never closed; put a \" at its end");
  }

  std::string_view text_, left_;
  std::string name_;
  char separator_;
  std::size_t line_ = 1;
};

bool is_formula(std::string_view text) {
  return !text.empty() && std::string_view("=+-@").find(text[0]) != std::string_view::npos;
}

std::string csv_cell(const std::string& text) {
  const std::string safe = (is_formula(text) ? "'" : "") + text;
  if (safe.find_first_of(",;\t\"") == std::string::npos) return safe;
  std::string result = "\"";
  for (const char c : safe) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

}  // namespace

std::vector<CsvRow> csv_rows(std::string_view text, const std::string& name) {
  check_is_text(text, name);
  return CsvReader(text, name).all();
}

std::string table_in(const std::filesystem::path& file) {
  if (auto text = small_file(file)) return *text;
  const std::string shown = "'" + printable_name(file.string()) + "'";
  if (!std::filesystem::exists(file)) throw Usage("there is no table " + shown);
  throw Usage("can't read " + shown + ", or it is longer than a megabyte");
}

std::vector<CsvRow> csv_file(const std::filesystem::path& file) {
  return csv_rows(table_in(file), printable_name(file.string()));
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) line += (i > 0 ? "," : "") + csv_cell(cells[i]);
  return line + "\r\n";
}

std::string as_was(const std::string& cell) {
  const bool made_safe = cell.starts_with('\'') && is_formula(std::string_view(cell).substr(1));
  return made_safe ? cell.substr(1) : cell;
}

void CsvChanges::set(const CsvRow& row, std::size_t column, const std::string& cell) {
  const CsvPlace& place = row.places.at(column);
  const bool was_quoted = place.size > 0 && text_[place.begin] == '"';
  std::string written = csv_cell(cell);
  if (was_quoted && written == cell) written = "\"" + cell + "\"";
  changes_[place.begin] = {place.size, written};
}

std::string CsvChanges::text() const {
  std::string result;
  std::size_t at = 0;
  for (const auto& [begin, change] : changes_) {
    result += text_.substr(at, begin - at) + change.second;
    at = begin + change.first;
  }
  return result + text_.substr(at);
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == text.npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

}  // namespace grade
