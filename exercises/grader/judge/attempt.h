// SPDX-License-Identifier: MIT-0
/// @file
/// Code of ours that may leave by an exception.
#pragma once
#include <functional>

namespace judge {

/// Returns whether it came to its end; false if it threw.
bool attempt(const std::function<void()>& act);

}  // namespace judge
