// SPDX-License-Identifier: MIT-0
#pragma once
#include <filesystem>
#include <string>

namespace grade {

/// What is filled in with what.
struct HandBack {
  std::string kind;               ///< `moodle` or `canvas`
  std::filesystem::path table;    ///< as the system exported it
  std::filesystem::path results;  ///< of one assignment of a course
  std::string column;             ///< of Canvas's gradebook
};

/// Fills a system's table in with the marks of a round, into a file of its own beside them,
/// `moodle.csv` or `canvas.csv`. All other cells stay as they came.
/// @returns the exit code
/// @throws Usage  what to mend
int hand_back(const HandBack& work);

}  // namespace grade
