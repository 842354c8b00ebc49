// SPDX-License-Identifier: MIT-0
/// @file
/// UTF-8, one character at a time, of bytes that may be anything.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace grade {

struct Character {
  char32_t code = 0;
  std::size_t bytes = 1;
  bool valid = false;  ///< if not, this is one byte that is no part of a character
};

/// The first character of a text that is not empty.
Character first_character(std::string_view text);

/// How many characters it has; each stray byte counts as one.
std::size_t characters(std::string_view text);

}  // namespace grade
