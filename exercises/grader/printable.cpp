// SPDX-License-Identifier: MIT-0
#include "printable.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace grade {

namespace {

unsigned char byte(std::string_view text, std::size_t at) {
  return static_cast<unsigned char>(text[at]);
}

std::uint32_t code_point(std::string_view character) {
  if (character.size() == 1) return byte(character, 0);
  std::uint32_t code = byte(character, 0) & (0x7fu >> character.size());
  for (std::size_t k = 1; k < character.size(); ++k)
    code = code << 6 | (byte(character, k) & 0x3fu);
  return code;
}

bool harmless(std::uint32_t code) {
  if (code == '\n') return true;
  if (code < 0x20 || (code >= 0x7f && code < 0xa0)) return false;
  const bool turns = code == 0x61c || code == 0x200e || code == 0x200f ||
                     (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  return !turns && code != 0xfeff;
}

std::string escaped(std::string_view bytes) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    text += "\\x";
    text += digits[byte(bytes, k) >> 4];
    text += digits[byte(bytes, k) & 15];
  }
  return text;
}

}  // namespace

std::size_t utf8_character(std::string_view text) {
  if (text.empty()) return 0;
  const unsigned char first = byte(text, 0);
  const std::size_t size = first < 0x80   ? 1
                           : first < 0xc2 ? 0
                           : first < 0xe0 ? 2
                           : first < 0xf0 ? 3
                           : first < 0xf5 ? 4
                                          : 0;
  if (size == 0 || size > text.size()) return 0;
  for (std::size_t k = 1; k < size; ++k)
    if ((byte(text, k) & 0xc0) != 0x80) return 0;
  // Written longer than need be, a half of a pair of UTF-16, or beyond the last character.
  const std::uint32_t code = code_point(text.substr(0, size));
  const bool wrong = (size == 3 && code < 0x800) || (size == 4 && code < 0x10000) ||
                     (code >= 0xd800 && code < 0xe000) || code > 0x10ffff;
  return wrong ? 0 : size;
}

std::string printable(std::string_view text, std::size_t most) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t size = utf8_character(text);
    const std::string_view next = text.substr(0, std::max<std::size_t>(1, size));
    if (shown.size() + next.size() > most) return shown + " [cut]";
    if (next == "\r") {
      // half of a line end, as Windows writes them
    } else if (next == "\t")
      shown += "    ";
    else if (size > 0 && harmless(code_point(next)))
      shown += next;
    else
      shown += escaped(next);
    text.remove_prefix(next.size());
  }
  return shown;
}

}  // namespace grade
