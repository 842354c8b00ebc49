// SPDX-License-Identifier: MIT-0
/// @file
/// report.json, as report.schema.json describes it.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "grade_submission.h"

namespace grade {

/// The name of its schema.
inline constexpr const char* report_schema = "one-step-at-a-time/report/v1";

/// The report as JSON in ASCII. All of it but the block `volatile` is the same for the same
/// submission, seed and grader.
std::string to_json(const Report& report);

/// Reads it back, without the curves of its plots; nothing if it is not a whole report.
std::optional<Report> report_from(std::string_view json);

}  // namespace grade
