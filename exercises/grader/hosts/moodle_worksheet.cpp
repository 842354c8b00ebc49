// SPDX-License-Identifier: MIT-0
#include "hosts/moodle_worksheet.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <regex>

#include "command_line.h"
#include "course/local_time.h"
#include "printable.h"

namespace grade {
namespace {

using Names = std::vector<std::string>;

std::optional<std::size_t> column_of(const CsvRow& head, const Names& names) {
  for (std::size_t i = 0; i < head.cells.size(); ++i)
    if (std::ranges::find(names, trimmed(head.cells[i])) != names.end()) return i;
  return std::nullopt;
}

/// The first three letters of the months, English and German.
int month_of(const std::string& word) {
  static const std::vector<Names> months{
      {"Jan"}, {"Feb"}, {"Mar", "Mär"}, {"Apr"},        {"May", "Mai"}, {"Jun"},
      {"Jul"}, {"Aug"}, {"Sep"},        {"Oct", "Okt"}, {"Nov"},        {"Dec", "Dez"}};
  for (std::size_t i = 0; i < months.size(); ++i)
    for (const std::string& begin : months[i])
      if (word.starts_with(begin)) return int(i) + 1;
  return 0;
}

}  // namespace

MoodleWorksheet::MoodleWorksheet(const std::filesystem::path& file) {
  const std::string shown = printable_name(file.string());
  text_ = table_in(file);
  rows_ = csv_rows(text_, shown);
  const CsvRow head = rows_.empty() ? CsvRow() : rows_[0];
  const auto id = column_of(head, {"Identifier", "ID"});
  const auto grade = column_of(head, {"Grade", "Bewertung"});
  if (!id || !grade)
    throw Usage(
        shown +
        ":1: a grading worksheet has the columns Identifier and Grade; set the assignment's "
        "'Offline grading worksheet', and download it with Moodle in English or German");
  id_ = *id;
  grade_ = *grade;
  name_ = column_of(head, {"Full name", "Vollständiger Name"});
  number_ = column_of(head, {"ID number", "ID-Nummer"});
  email_ = column_of(head, {"Email address", "E-Mail-Adresse"});
  submitted_ = column_of(head, {"Last modified (submission)", "Zuletzt geändert (Abgabe)"});
  most_ = column_of(head, {"Maximum Grade", "Maximum grade", "Bestwertung"});
  comment_ = column_of(head, {"Feedback comments", "Feedback als Kommentar"});
  rows_.erase(rows_.begin());
}

std::optional<std::string> MoodleWorksheet::cell(const CsvRow& row,
                                                 std::optional<std::size_t> column) const {
  if (!column || *column >= row.cells.size()) return std::nullopt;
  return trimmed(row.cells[*column]);
}

std::string MoodleWorksheet::number(const CsvRow& row) const {
  const std::string text = cell(row, id_).value_or("");
  const std::size_t before = text.find_last_not_of("0123456789");
  return before == text.npos ? text : text.substr(before + 1);
}

std::optional<std::string> moodle_time(const std::string& text) {
  constexpr std::size_t longest_time = 100;
  static const std::regex form(
      R"((?:[^,]*, )?([0-9]{1,2})\.? ([^ .]+)\.? ([0-9]{4}),? ([0-9]{1,2}):([0-9]{2}) ?([AaPp][Mm])?)");
  std::smatch parts;
  if (text.size() > longest_time || !std::regex_match(text, parts, form)) return std::nullopt;
  const int month = month_of(parts[2]);
  int hour = std::stoi(parts[4]);
  if (parts[6].matched && (hour < 1 || hour > 12)) return std::nullopt;
  if (parts[6].matched) hour = hour % 12 + (std::tolower(*parts[6].first) == 'p' ? 12 : 0);
  char written[32];
  std::snprintf(written, sizeof written, "%s-%02d-%02dT%02d:%s", parts[3].str().c_str(), month,
                std::stoi(parts[1]), hour, parts[5].str().c_str());
  return time_from(written) ? std::optional<std::string>(written) : std::nullopt;
}

std::map<std::string, std::string> times_in(const MoodleWorksheet& sheet, const std::string& name) {
  std::map<std::string, std::string> times;
  for (const CsvRow& row : sheet.rows()) {
    const std::string where = name + ":" + std::to_string(row.line) + ": ";
    const auto submitted = sheet.submitted(row);
    if (!submitted) throw Usage(where + "there is no column 'Last modified (submission)'");
    if (submitted->empty() || *submitted == "-") continue;
    const auto time = moodle_time(*submitted);
    if (!time)
      throw Usage(where + "'" + printable_name(*submitted) +
                  "' is no time as Moodle writes it in English or German; download the worksheet "
                  "in one of these, or write it as 8 February 2027, 23:59");
    times[sheet.number(row)] = *time;
  }
  return times;
}

std::map<std::string, Person> people_in(const MoodleWorksheet& sheet) {
  std::map<std::string, Person> people;
  for (const CsvRow& row : sheet.rows())
    people[sheet.number(row)] = {sheet.name(row).value_or(""), sheet.id_number(row).value_or(""),
                                 sheet.email(row).value_or("")};
  return people;
}

}  // namespace grade
