// SPDX-License-Identifier: MIT-0
/// @file
/// The machine that this runs on.
#pragma once
#include <fstream>
#include <string>

namespace measure {

/// What /proc/cpuinfo says of the first processor, such as its "model name"; empty if it doesn't.
inline std::string processor_says(const std::string& what) {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with(what) && colon != line.npos) return line.substr(colon + 2);
  }
  return "";
}

/// The processor, as the system names it.
inline std::string machine() {
  const std::string name = processor_says("model name");
  return name.empty() ? "an unnamed processor" : name;
}

}  // namespace measure
