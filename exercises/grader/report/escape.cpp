// SPDX-License-Identifier: MIT-0
#include "report/escape.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "printable.h"

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

/// The number of a character of UTF-8.
char32_t code_of(std::string_view character) {
  constexpr unsigned bits_of_first[] = {0, 0x7f, 0x1f, 0x0f, 0x07};
  char32_t code = static_cast<unsigned char>(character[0]) & bits_of_first[character.size()];
  for (const char c : character.substr(1))
    code = code << 6 | (static_cast<unsigned char>(c) & 0x3f);
  return code;
}

/// Takes the first character off a text that is not empty, and shows it.
std::string take_first(std::string_view& text) {
  const std::size_t bytes = utf8_character(text);
  const std::string_view character = text.substr(0, std::max<std::size_t>(1, bytes));
  text.remove_prefix(character.size());
  if (bytes == 0) return spelled("\\x%02x", static_cast<unsigned char>(character[0]));
  const char32_t code = code_of(character);
  const bool control = code < 0x20 || (code >= 0x7f && code < 0xa0);
  if (control) return spelled("\\x%02x", static_cast<unsigned>(code));
  if (!has_shape(code)) return spelled("\\u{%x}", static_cast<unsigned>(code));
  return std::string(character);
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
    if (text.starts_with("\r\n")) text.remove_prefix(1);
    const bool stays = text[0] == '\n' || text[0] == '\t';
    const char first = text[0];
    const std::string shown = take_first(text);
    result += stays ? std::string(1, first) : shown;
  }
  return without_commands(result);
}

std::string printable_name(std::string_view name) {
  std::string result;
  for (char last = '\0'; !name.empty();) {
    const char first = name[0];
    const bool command = result.empty() ? first == ':' : first == '#' && last == '#';
    const std::string shown = take_first(name);
    const bool spell = first == '\\' || command;
    result += spell ? spelled("\\x%02x", static_cast<unsigned char>(first)) : shown;
    last = first;
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
