// SPDX-License-Identifier: MIT-0
/// @file
/// A word for another, all through a text.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace grade {

/// Each `from`, which is not empty, becomes `to`.
inline std::string replace_all(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace grade
