// SPDX-License-Identifier: MIT-0
#include "report/utf8.h"

#include <array>

namespace grade {
namespace {

/// A first byte: how many bytes the character has, which bits of it count, and the least character
/// that needs so many bytes.
struct Lead {
  unsigned mask, pattern;
  std::size_t bytes;
  char32_t least;
};

constexpr std::array leads{Lead{0x80, 0x00, 1, 0}, Lead{0xe0, 0xc0, 2, 0x80},
                           Lead{0xf0, 0xe0, 3, 0x800}, Lead{0xf8, 0xf0, 4, 0x10000}};

unsigned byte(std::string_view text, std::size_t at) {
  return static_cast<unsigned char>(text[at]);
}

Character read(std::string_view text, const Lead& lead) {
  if (text.size() < lead.bytes) return {};
  char32_t code = byte(text, 0) & ~lead.mask;
  for (std::size_t i = 1; i < lead.bytes; ++i) {
    if ((byte(text, i) & 0xc0) != 0x80) return {};
    code = code << 6 | (byte(text, i) & 0x3f);
  }
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  if (code < lead.least || code > 0x10ffff || surrogate) return {};
  return {code, lead.bytes, true};
}

}  // namespace

Character first_character(std::string_view text) {
  for (const Lead& lead : leads) {
    if ((byte(text, 0) & lead.mask) == lead.pattern) return read(text, lead);
  }
  return {};
}

std::size_t characters(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) text.remove_prefix(first_character(text).bytes);
  return count;
}

}  // namespace grade
