// SPDX-License-Identifier: MIT-0
/// @file
/// Diagnoses of a wrong answer, from its numbers.
#pragma once
#include <string>
#include <vector>

#include "judge/method.h"
#include "judge/path.h"

namespace judge {

/// Diagnoses of a path that is not the expected one; several, or none.
/// @param yours  the student's
/// @param asked  the method that was asked for
/// @param run_by  runs a method over the same steps, to see whether it is the student's
std::vector<std::string> diagnose(const Path& yours, const Method& asked,
                                  const std::function<Path(const Method&)>& run_by);

/// The first place at which the force was asked for, and should not have been, or how often it was
/// asked for in vain; nothing if all is as expected.
std::vector<std::string> asked_elsewhere(const Path& yours, const Path& expected);

/// Returns whether a number that is off by this, beside its size, may have gone through a float:
/// nine of ten that did are further off than the one bound, and all are nearer than the other.
/// @param least  a smaller bound, where the float may count little beside the rest
constexpr bool like_a_float(double off, double least = 4e-9) {
  return off > least && off < 2e-6;
}

/// Diagnoses of a single number: its sign, its unit, its precision.
std::vector<std::string> diagnose(double yours, double expected);

}  // namespace judge
