// SPDX-License-Identifier: MIT-0
/// @file
/// The points of a test, as its tag says them.
#pragma once
#include <charconv>
#include <cstddef>
#include <string_view>
#include <system_error>

namespace judge {

/// Of the tag `4 points`; 0 of any other.
inline int points_of(std::string_view tag) {
  const std::size_t end = tag.find(" point");
  int points = 0;
  const bool is_one =
      end != tag.npos && std::from_chars(tag.data(), tag.data() + end, points).ec == std::errc();
  return is_one ? points : 0;
}

}  // namespace judge
