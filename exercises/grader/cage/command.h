// SPDX-License-Identifier: MIT-0
/// @file
/// The command lines that make a cage.
#pragma once
#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "cage.h"

namespace cage {

using Words = std::vector<std::string>;

/// The user that root becomes before it starts anything: one that nobody else has, since a limit on
/// processes does not hold for root. Nothing for all others.
std::optional<uid_t> unprivileged();

/// The words before any command: setpriv, to another user for root, and prlimit, for the limits.
Words limits_prefix(Sandbox sandbox, const Limits& limits, int open_files);

/// Starts the driver on descriptor 8 under the filter on descriptor 9.
Words run_command(Sandbox sandbox, const Limits& limits);

/// Starts a driver with a checker of memory, which finds its libraries; descriptor 10 is the
/// program that limits it.
Words check_command(Sandbox sandbox, const Kit& kit, const Limits& limits);

/// Compiles in the cage: the header on descriptor 8, harness.h on 7, the glue on 6, the filter
/// on 9.
/// @param harness  words for bubblewrap that show the kit's harness at /job/harness
Words compile_command(const Kit& kit, const Words& harness, const std::string& header,
                      const Limits& limits, Build build);

/// Compiles in a folder that holds all these by their names.
Words compile_command(const Kit& kit, const std::string& folder, const Limits& limits, Build build);

}  // namespace cage
