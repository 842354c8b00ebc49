// SPDX-License-Identifier: MIT-0
/// @file
/// States and starts in words, with all digits: whoever shows them leaves out what nobody needs.
#pragma once
#include <string>

#include "harness/force.h"
#include "judge/path.h"

namespace judge {

std::string describe(const Vec& vector, int digits = 17);
std::string describe(const State& state, int digits = 17);
std::string describe(const Start& start);

/// A force, with its constants.
std::string describe(const harness::Force& force);

}  // namespace judge
