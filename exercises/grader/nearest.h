// SPDX-License-Identifier: MIT-0
/// @file
/// Did you mean ...?
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace grade {

/// The number of letters that must be put in, taken out or changed (Levenshtein's distance).
std::size_t edit_distance(const std::string& a, const std::string& b);

/// The name that is most likely meant by `wanted`: the same up to case, `-` and `_` or the ending,
/// or a few letters off. Empty if none is near.
std::string nearest(const std::string& wanted, const std::vector<std::string>& names);

}  // namespace grade
