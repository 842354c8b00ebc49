// SPDX-License-Identifier: MIT-0
/// @file
/// The table of times that a course reads.
#pragma once
#include <filesystem>

#include "hosts/haul.h"

namespace grade {

/// Seconds on UTC's clocks, as such a table has them.
std::string as_written(Instant time);

/// @throws Usage  the table that is there is another one
void check_is_ours(const std::filesystem::path& table);

/// Says when each file was handed in, by the folder of its student: in a table beside the folder of
/// submissions, whose other lines stay. A file of which nobody knows the time has an empty cell,
/// which a course asks to fill in. Without any time there is nothing to write.
/// @returns whether it was written
/// @throws Usage  the table that is there is another one
bool write_times(const Haul& haul, const std::filesystem::path& table);

}  // namespace grade
