// SPDX-License-Identifier: MIT-0
/// @file
/// A table of TOML, of which every key is known and every value is what it should be.
#pragma once
#include <toml++/toml.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "course/local_time.h"

namespace grade {

/// Whatever is wrong is thrown as Usage, in one line that begins with the place.
class TomlTable {
 public:
  /// @param known  its keys; another one is an error
  TomlTable(const toml::table& table, const std::string& file,
            std::initializer_list<std::string_view> known);

  bool has(std::string_view key) const { return table_.contains(key); }
  bool is_table(std::string_view key) const {
    return table_.get(key) && table_.get(key)->is_table();
  }
  std::optional<std::string> text(std::string_view key) const;  ///< in one line, not empty
  std::string needed_text(std::string_view key) const;
  std::vector<std::string> needed_texts(std::string_view key) const;  ///< at least one, each once
  std::optional<bool> yes_or_no(std::string_view key) const;
  std::optional<int> whole(std::string_view key, int least, int most) const;

  /// @param latest  which of two instants is meant, where the clocks show the time twice
  std::optional<Instant> time(std::string_view key, const TimeZone& zone, bool latest) const;
  Instant needed_time(std::string_view key, const TimeZone& zone) const;

  /// The table under this key, or null; and those of `[[key]]`.
  const toml::table* table(std::string_view key) const;
  std::vector<const toml::table*> tables(std::string_view key) const;

  /// The place of a value; of the table itself if there is none.
  std::string place(std::string_view key = "") const;

  [[noreturn]] void refuse(std::string_view key, const std::string& why) const;

 private:
  const toml::node& needed(std::string_view key, const std::string& such_as) const;
  const toml::table& table_;
  std::string file_;
};

/// `course.toml:12:5`
std::string toml_place(const std::string& file, const toml::source_region& where);

}  // namespace grade
