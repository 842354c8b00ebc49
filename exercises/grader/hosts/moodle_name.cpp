// SPDX-License-Identifier: MIT-0
#include "hosts/moodle_name.h"

#include <cstddef>
#include <regex>
#include <string_view>

namespace grade {

std::string MoodleName::folder() const {
  return name + "_" + number + "_assignsubmission_" + kind + "_";
}

std::optional<MoodleName> moodle_name(const std::string& text) {
  // Long names would exhaust the stack of std::regex; the longest of a file is 255 bytes.
  constexpr std::size_t longest_name = 255;
  static const std::regex form("([^_]*)_([0-9]+)_assignsubmission_([a-z]+)(?:_([^]*))?");
  std::smatch parts;
  if (text.size() > longest_name || !std::regex_match(text, parts, form)) return std::nullopt;
  return MoodleName{parts[1], parts[2], parts[3], parts[4]};
}

std::string as_moodle_writes(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (std::string_view("&<>\"`|':\\/").find(c) == std::string_view::npos)
      text += c == '_' ? ' ' : c;
  }
  return text;
}

}  // namespace grade
