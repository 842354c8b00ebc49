// SPDX-License-Identifier: MIT-0
/// @file
/// Pictures of what went wrong.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grade_submission.h"

namespace grade {

/// The picture as SVG on white, the student's curve solid and the others dashed, below 30 kB;
/// nothing if no curve has a point, or gnuplot cannot draw it.
std::optional<std::string> svg(const Plot& plot);

/// Returns whether any curve has a point.
bool can_be_drawn(const Plot& plot);

/// The reason why there is no picture where there was one to be drawn, in a few words.
std::string_view why_no_picture(const Plot& plot);

/// The pictures in `folder`/plots that have the names of the grader's.
std::vector<std::filesystem::path> plots_in(const std::filesystem::path& folder);

/// Draws what the failed tests have to show into `folder`/plots, in place of what an earlier
/// grading drew there, and notes where.
/// @throws std::system_error  it could not be written
/// @throws NotOwn  a link, or no folder, stands there
void draw(Report& report, const std::filesystem::path& folder);

}  // namespace grade
