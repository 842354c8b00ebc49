// SPDX-License-Identifier: MIT-0
/// @file
/// States and starts in words, with all the digits that it takes to try them at home.
#pragma once
#include <string>

#include "harness/force.h"
#include "judge/path.h"

namespace judge {

std::string describe(const Vec& vector, int digits = 6);
std::string describe(const State& state, int digits = 6);
std::string describe(const Start& start);

/// What pushes, with its constants.
std::string describe(const harness::Force& force);

}  // namespace judge
