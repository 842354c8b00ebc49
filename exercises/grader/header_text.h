// SPDX-License-Identifier: MIT-0
/// @file
/// The test whether a file can be a header at all.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace grade {

/// The most that a header may hold [bytes]: far more than any of the exercises needs.
constexpr std::size_t longest = 65536;

/// Empty if it is UTF-8 text of that length; else what it is, and what to do.
std::string not_a_header(std::string_view content);

}  // namespace grade
