// SPDX-License-Identifier: MIT-0
/// @file
/// Numbers in a text, with no more digits than a reader needs. All of them stand in report.json.
#pragma once
#include <string>
#include <utility>

namespace grade {

/// Numbers of more than so many digits in the shortest form that has so many.
std::string shortened(const std::string& text, int digits = 6);

/// Returns what is expected and what came, both with as many digits as it takes to tell them apart,
/// and with six at least.
std::pair<std::string, std::string> told_apart(const std::string& expected, const std::string& got);

}  // namespace grade
