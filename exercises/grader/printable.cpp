// SPDX-License-Identifier: MIT-0
#include "printable.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

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

/// The number of a character whose bytes have the right form.
char32_t code_point(std::string_view character) {
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
  const char32_t code = code_point(character);
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

}  // namespace

std::size_t utf8_character(std::string_view text) {
  if (text.empty()) return 0;
  const unsigned char first = static_cast<unsigned char>(text[0]);
  const std::size_t size = first < 0x80   ? 1
                           : first < 0xc2 ? 0
                           : first < 0xe0 ? 2
                           : first < 0xf0 ? 3
                           : first < 0xf5 ? 4
                                          : 0;
  if (size == 0 || size > text.size()) return 0;
  for (const char c : text.substr(1, size - 1))
    if ((static_cast<unsigned char>(c) & 0xc0) != 0x80) return 0;
  // Written longer than need be, a half of a pair of UTF-16, or beyond the last character.
  const char32_t code = code_point(text.substr(0, size));
  const bool wrong = (size == 3 && code < 0x800) || (size == 4 && code < 0x10000) ||
                     (code >= 0xd800 && code < 0xe000) || code > 0x10ffff;
  return wrong ? 0 : size;
}

std::string printable(std::string_view text, std::size_t most) {
  std::string shown;
  while (!text.empty()) {
    if (text.starts_with("\r\n")) text.remove_prefix(1);
    const char first = text[0];
    const std::string spelled_out = take_first(text);
    const std::string next = first == '\n' || first == '\t' ? std::string(1, first) : spelled_out;
    if (next.size() > most - shown.size()) return without_commands(shown) + " [cut]";
    shown += next;
  }
  return without_commands(shown);
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

}  // namespace grade
