// SPDX-License-Identifier: MIT-0
#pragma once
#include <filesystem>

namespace grade {

/// Writes Gradescope's results.json of all reports that lie in a folder, by the names of their
/// exercises: `reports/2-euler/orbit-drift/report.json`.
/// @returns the exit code; without a grade for each nothing is written
/// @throws Usage  there is none
int write_gradescope(const std::filesystem::path& reports, const std::filesystem::path& results);

}  // namespace grade
