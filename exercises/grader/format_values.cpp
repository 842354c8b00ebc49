// SPDX-License-Identifier: MIT-0
#include "format_values.h"

#include <cmath>
#include <cstdio>

namespace grade {

std::string number(double value, int digits) {
  if (std::isnan(value)) return "NaN";  // whose sign means nothing
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string megabytes(std::size_t bytes) {
  return number(static_cast<double>(bytes) / 1e6, 4) + " MB";
}

std::string counted(std::size_t number, const std::string& thing) {
  return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

std::string seconds(const cage::Limits& limits) {
  return number(limits.processor, 3) + " s of processor time or " + number(limits.wall, 3) +
         " s on the clock";
}

}  // namespace grade
