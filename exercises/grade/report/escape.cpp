// SPDX-License-Identifier: MIT-0
#include "report/escape.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "report/utf8.h"

namespace grade {
namespace {

/// Characters that have no shape of their own, or turn the direction of what follows.
constexpr std::array<std::pair<char32_t, char32_t>, 12> shapeless{{{0xad, 0xad},
                                                                   {0x61c, 0x61c},
                                                                   {0x115f, 0x1160},
                                                                   {0x180e, 0x180e},
                                                                   {0x200b, 0x200f},
                                                                   {0x2028, 0x202e},
                                                                   {0x2060, 0x206f},
                                                                   {0xfe00, 0xfe0f},
                                                                   {0xfeff, 0xfeff},
                                                                   {0xfff0, 0xfffb},
                                                                   {0xfffe, 0xffff},
                                                                   {0xe0000, 0xe0fff}}};

bool has_shape(char32_t code) {
  return std::none_of(shapeless.begin(), shapeless.end(), [&](const auto& range) {
    return code >= range.first && code <= range.second;
  });
}

std::string spelled(const char* format, unsigned code) {
  char text[16];
  std::snprintf(text, sizeof text, format, code);
  return text;
}

std::string shown(std::string_view text, const Character& character) {
  const unsigned first = static_cast<unsigned char>(text[0]);
  if (!character.valid) return spelled("\\x%02x", first);
  const bool control = character.code < 0x20 || (character.code >= 0x7f && character.code < 0xa0);
  if (control) return spelled("\\x%02x", static_cast<unsigned>(character.code));
  if (!has_shape(character.code)) return spelled("\\u{%x}", static_cast<unsigned>(character.code));
  return std::string(text.substr(0, character.bytes));
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// GitHub takes `::error` at the start of a line, and Azure, GitHub and TeamCity `##[error]`,
/// `##vso[` and `##teamcity[` anywhere in it.
std::string without_commands(std::string_view text) {
  std::string result;
  bool line_starts = true;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i], next = i + 1 < text.size() ? text[i + 1] : '\0';
    const bool colons = line_starts && c == ':' && next == ':';
    const bool hashes = i > 0 && text[i - 1] == '#' && c == '#' && (next == '[' || is_letter(next));
    result += c;
    if (colons || hashes) result += ' ';
    line_starts = c == '\n' || (line_starts && (c == ' ' || c == '\t'));
  }
  return result;
}

std::string_view entity(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {};
  }
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Character character = first_character(text);
    const bool stays = text[0] == '\n' || text[0] == '\t';
    if (!text.starts_with("\r\n"))
      result += stays ? std::string(1, text[0]) : shown(text, character);
    text.remove_prefix(character.bytes);
  }
  return without_commands(result);
}

std::string printable_name(std::string_view name) {
  std::string result;
  for (char last = ':'; !name.empty(); name.remove_prefix(first_character(name).bytes)) {
    const bool command = name[0] == last && (last == ':' ? result.empty() : last == '#');
    const bool spell = name[0] == '\\' || command;
    result += spell ? spelled("\\x%02x", static_cast<unsigned char>(name[0]))
                    : shown(name, first_character(name));
    last = name[0];
  }
  return result;
}

std::string html(std::string_view text) {
  const std::string shown = printable(text);
  std::string result;
  for (const char c : std::string_view(shown)) {
    const std::string_view replacement = entity(c);
    result += replacement.empty() ? std::string_view(&c, 1) : replacement;
  }
  return result;
}

}  // namespace grade
