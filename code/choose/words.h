// SPDX-License-Identifier: MIT-0
/// @file
/// Numbers in words.
#pragma once
#include <cstdio>
#include <string>

/// A number in a few digits.
inline std::string format_number(double value, int digits = 2) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

/// "1 step", "2 steps".
inline std::string steps(long count) {
  return std::to_string(count) + (count == 1 ? " step" : " steps");
}

/// A number above a bound, in as many digits as show that it is above, three at least.
inline std::string format_above(double value, double bound) {
  int digits = 3;
  while (digits < 17 && std::stod(format_number(value, digits)) <= bound) ++digits;
  return format_number(value, digits);
}
