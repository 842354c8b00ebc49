// SPDX-License-Identifier: MIT-0
/// @file
/// The folder in which a report is kept.
#pragma once
#include <filesystem>
#include <set>
#include <string>

#include "grade_submission.h"
#include "report/words.h"

namespace grade {

/// Formats of others, written beside the report.
enum class Emit { gradescope, junit };

/// Writes the formats that are wanted, and takes away the others, which would tell of an older
/// report.
/// @throws std::system_error  one line that says what could not be written, and why
void emit(const Report& report, const std::filesystem::path& folder, const std::set<Emit>& emits);

/// The name of a link, a pipe or the like that stands there in place of a file or a folder of the
/// grader's; empty if none does.
std::string irregular_file(const std::filesystem::path& folder);

/// The name of a file there that would be lost, if this is not a folder of the grader's own; empty
/// if nothing would be.
std::string foreign_file(const std::filesystem::path& folder);

/// Says that a grading is under way: until keep() replaces it, the folder tells of a grader that
/// was stopped before it came to a verdict. Makes the folder.
/// @param report  as far as it is known; its verdict and its reason are not kept
/// @throws std::system_error  one line that says what could not be written, and why
void keep_provisional(Report report, const std::filesystem::path& folder,
                      const std::set<Emit>& emits);

/// Writes plots, feedback.md, what is to be emitted, and at last report.json. Notes in the report
/// where its plots are.
/// @param place  for what to run next
/// @throws std::system_error  one line that says what could not be written, and why
void keep(Report& report, const std::filesystem::path& folder, const std::set<Emit>& emits,
          const Place& place = {});

}  // namespace grade
