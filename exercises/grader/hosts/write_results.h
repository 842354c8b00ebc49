// SPDX-License-Identifier: MIT-0
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "grade_submission.h"

namespace grade {

/// Writes a host's file of all reports that lie in a folder, by the names of their exercises:
/// `reports/2-euler/orbit-drift/report.json`.
/// @param format  the content of the file
/// @returns the exit code; without a grade for each nothing is written
/// @throws Usage  there is none
int write_results(const std::filesystem::path& reports, const std::filesystem::path& results,
                  std::string (*format)(const std::vector<Report>& all));

}  // namespace grade
