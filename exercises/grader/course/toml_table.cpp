// SPDX-License-Identifier: MIT-0
#include "course/toml_table.h"

#include <algorithm>

#include "command_line.h"
#include "nearest.h"
#include "printable.h"

namespace grade {
namespace {

using namespace std::string_literals;

std::string quoted_key(std::string_view key) {
  return "'" + printable_name(key) + "'";
}

std::string listed_keys(std::initializer_list<std::string_view> keys) {
  std::string text;
  for (const std::string_view key : keys) text += (text.empty() ? "" : ", ") + std::string(key);
  return text;
}

constexpr const char* time_form = "a time without quotes, such as 2027-02-08T23:59:00";

bool is_one_line(const std::string& text) {
  return !text.empty() && text.find_first_of("\n\r") == text.npos && text.find('\0') == text.npos;
}

LocalTime local_of(const toml::date_time& time) {
  namespace chrono = std::chrono;
  const chrono::year_month_day date(chrono::year(time.date.year), chrono::month(time.date.month),
                                    chrono::day(time.date.day));
  return chrono::local_days(date) + chrono::hours(time.time.hour) +
         chrono::minutes(time.time.minute) + chrono::seconds(time.time.second);
}

}  // namespace

std::string toml_place(const std::string& file, const toml::source_region& where) {
  return file + ":" + std::to_string(where.begin.line) + ":" + std::to_string(where.begin.column);
}

TomlTable::TomlTable(const toml::table& table, const std::string& file,
                     std::initializer_list<std::string_view> known)
    : table_(table), file_(file) {
  for (const auto& [key, value] : table) {
    if (std::ranges::find(known, key.str()) != known.end()) continue;
    const std::vector<std::string> names(known.begin(), known.end());
    const std::string near = nearest(std::string(key.str()), names);
    throw Usage(toml_place(file, key.source()) + ": there is no key " + quoted_key(key.str()) +
                (near.empty() ? " here; known are " + listed_keys(known)
                              : "; did you mean '" + near + "'?"));
  }
}

std::string TomlTable::place(std::string_view key) const {
  const toml::node* const value = table_.get(key);
  return toml_place(file_, value ? value->source() : table_.source());
}

void TomlTable::refuse(std::string_view key, const std::string& why) const {
  throw Usage(place(key) + ": " + why);
}

const toml::node& TomlTable::needed(std::string_view key, const std::string& such_as) const {
  if (const toml::node* const value = table_.get(key)) return *value;
  refuse(key, quoted_key(key) + " is missing here; write " + such_as);
}

std::optional<std::string> TomlTable::text(std::string_view key) const {
  const toml::node* const value = table_.get(key);
  if (!value) return std::nullopt;
  const auto text = value->value_exact<std::string>();
  if (!text || !is_one_line(*text))
    refuse(key, quoted_key(key) + " must be one line of text in quotes, such as \"here\"");
  return text;
}

std::string TomlTable::needed_text(std::string_view key) const {
  needed(key, std::string(key) + " = \"...\"");
  return *text(key);
}

std::vector<std::string> TomlTable::needed_texts(std::string_view key) const {
  const std::string form = std::string(key) + " = [\"...\", \"...\"]";
  const toml::array* const all = needed(key, form).as_array();
  if (!all || all->empty()) refuse(key, quoted_key(key) + " must be a list: " + form);
  std::vector<std::string> texts;
  for (const toml::node& one : *all) {
    const auto text = one.value_exact<std::string>();
    const std::string where = toml_place(file_, one.source()) + ": ";
    if (!text) throw Usage(where + quoted_key(key) + " must hold texts in quotes: " + form);
    if (std::ranges::find(texts, *text) != texts.end())
      throw Usage(where + quoted_key(*text) + " stands here twice; take one away");
    texts.push_back(*text);
  }
  return texts;
}

std::optional<bool> TomlTable::yes_or_no(std::string_view key) const {
  const toml::node* const value = table_.get(key);
  if (!value) return std::nullopt;
  const auto answer = value->value_exact<bool>();
  if (!answer) refuse(key, quoted_key(key) + " must be true or false, without quotes");
  return answer;
}

std::optional<int> TomlTable::whole(std::string_view key, int least, int most) const {
  const toml::node* const value = table_.get(key);
  if (!value) return std::nullopt;
  const auto number = value->value_exact<std::int64_t>();
  if (!number || *number < least || *number > most)
    refuse(key, quoted_key(key) + " must be a whole number from " + std::to_string(least) + " to " +
                    std::to_string(most) + ", without quotes");
  return int(*number);
}

std::optional<Instant> TomlTable::time(std::string_view key, const TimeZone& zone,
                                       bool latest) const {
  const toml::node* const value = table_.get(key);
  if (!value) return std::nullopt;
  const auto time = value->value_exact<toml::date_time>();
  if (!time && value->is_date())
    refuse(key, quoted_key(key) + " is a day; write the time of the day too, such as T23:59:00");
  if (!time) refuse(key, quoted_key(key) + " must be " + time_form);
  const LocalTime local = local_of(*time);
  if (time->offset)
    return Instant(local.time_since_epoch() - std::chrono::minutes(time->offset->minutes));
  const std::vector<Instant> found = zone.instants(local);
  if (found.empty())
    refuse(key, "there is no " + shown(local) + " in " + zone.name() +
                    ", since the clocks are put forward; name a time before or after");
  return latest ? found.back() : found.front();
}

Instant TomlTable::needed_time(std::string_view key, const TimeZone& zone) const {
  needed(key, std::string(key) + " = 2027-02-08T23:59:00, without quotes");
  return *time(key, zone, true);
}

const toml::table* TomlTable::table(std::string_view key) const {
  const toml::node* const value = table_.get(key);
  if (value && !value->is_table())
    refuse(key, quoted_key(key) + " must be a table: " + std::string(key) + " = { ... }");
  return value ? value->as_table() : nullptr;
}

std::vector<const toml::table*> TomlTable::tables(std::string_view key) const {
  const toml::node* const value = table_.get(key);
  if (!value) return {};
  const std::string cure = quoted_key(key) + " must be written as [[" + std::string(key) + "]]";
  if (!value->is_array()) refuse(key, cure);
  std::vector<const toml::table*> found;
  for (const toml::node& one : *value->as_array()) {
    if (!one.is_table()) throw Usage(toml_place(file_, one.source()) + ": " + cure);
    found.push_back(one.as_table());
  }
  return found;
}

}  // namespace grade
