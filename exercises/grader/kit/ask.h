// SPDX-License-Identifier: MIT-0
#pragma once
#include <string>
#include <vector>

#include "cage/process.h"

namespace grade {

/// Runs a program of the system, with none of the caller's variables.
/// @returns what it printed
/// @throws std::runtime_error  it did not come to a good end; in its own words
cage::Ended ask(const std::vector<std::string>& command, const std::string& folder = "/");

}  // namespace grade
