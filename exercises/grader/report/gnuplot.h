// SPDX-License-Identifier: MIT-0
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace grade {

/// Returns what gnuplot prints for this script, with its own defaults and none of the user's;
/// nothing if there is no gnuplot, or it fails.
std::optional<std::string> gnuplot(std::string_view script);

}  // namespace grade
