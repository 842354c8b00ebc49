// SPDX-License-Identifier: MIT-0
/// @file
/// Values in words, for messages.
#pragma once
#include <cstddef>
#include <string>

#include "cage/process.h"

namespace grade {

/// Six digits, enough to see a difference; `digits` if more are wanted.
std::string number(double value, int digits = 6);

std::string megabytes(std::size_t bytes);

/// `1 student`, `2 students`
std::string counted(std::size_t number, const std::string& thing);

/// The processor time that a program may use.
std::string seconds(const cage::Limits& limits);

}  // namespace grade
