// SPDX-License-Identifier: MIT-0
/// @file
/// Text from outside, made fit to be shown.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace grade {

/// The number of bytes at the front that are one character of UTF-8; 0 if they are none.
std::size_t utf8_character(std::string_view text);

/// Text in which nothing is hidden and nothing is a command: control characters, stray bytes and
/// characters without a shape are spelled out, and what CI services take as commands (`::error`,
/// `##[group]`) is broken by a space. Line ends and tabs stay.
/// @param most  bytes that are shown; what is longer is cut, and says so
std::string printable(std::string_view text, std::size_t most = std::string_view::npos);

/// A name as printable text in one line; no two names become the same.
std::string printable_name(std::string_view name);

}  // namespace grade
