// SPDX-License-Identifier: MIT-0
#pragma once
#include <string>
#include <vector>

namespace grade {

/// Prints the first few names, one in a line, and how many more there are.
void print_some(const char* what, const std::vector<std::string>& names);

}  // namespace grade
