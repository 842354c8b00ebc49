// SPDX-License-Identifier: MIT-0
#include "words.h"

#include <cstdio>

namespace grade {

std::string printable(std::string_view text, std::size_t most) {
  std::string safe;
  for (const char letter : text.substr(0, most)) {
    const auto code = static_cast<unsigned char>(letter);
    if (letter == '\n' || (code >= 0x20 && code < 0x7f)) {
      safe += letter;
    } else if (letter == '\t') {
      safe += "    ";
    } else if (letter != '\r') {
      char escaped[5];
      std::snprintf(escaped, sizeof escaped, "\\x%02x", code);
      safe += escaped;
    }
  }
  if (text.size() > most) safe += "\n[cut]";
  return safe;
}

std::string number(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string megabytes(std::size_t bytes) {
  return number(static_cast<double>(bytes) / 1e6, 3) + " MB";
}

std::string seconds(const cage::Limits& limits) {
  return number(limits.processor, 3) + " s of processor time or " + number(limits.wall, 3) +
         " s on the clock";
}

}  // namespace grade
