// SPDX-License-Identifier: MIT-0
/// @file
/// Text from outside, made fit to be shown.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace grade {

/// How many bytes at the front are one character of UTF-8; 0 if they are none.
std::size_t utf8_character(std::string_view text);

/// Letters of all languages and line ends stay; tabs become blanks; control characters, marks that
/// turn the direction of writing, and bytes that are not UTF-8 are written as `\x1b`. What is
/// longer than `most` bytes is cut.
std::string printable(std::string_view text, std::size_t most);

}  // namespace grade
