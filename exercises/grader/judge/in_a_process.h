// SPDX-License-Identifier: MIT-0
/// @file
/// Code of ours that may crash, never return, or remember what it should not.
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

namespace judge {

/// Computes so many numbers in a process of their own, with which ends what they remember. One that
/// crashes, or takes longer than it may, is infinite, and the next begins anew.
/// @param compute  the number of that place
/// @param longest  processor time of one number [ms]
std::vector<double> in_a_process(std::size_t count,
                                 const std::function<double(std::size_t place)>& compute,
                                 int longest = 500);

/// A single number.
double in_a_process(const std::function<double()>& compute);

}  // namespace judge
