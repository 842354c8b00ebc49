// SPDX-License-Identifier: MIT-0
/// @file
/// The machine that this runs on.
#pragma once
#include <cstdio>
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

/// The processor, as the system names it, and its family: systems that run on others often hide the
/// name.
inline std::string machine() {
  std::string name = processor_says("model name");
  const std::string family = processor_says("cpu family");
  if (name.empty()) return "an unnamed processor";
  if (family.empty()) return name;
  return name + " (family " + family + ", model " + processor_says("model\t") + ")";
}

/// The clock of the processor while this is asked.
inline std::string clock_rate() {
  const std::string mhz = processor_says("cpu MHz");
  if (mhz.empty()) return "a clock that the system does not tell";
  char text[32];
  std::snprintf(text, sizeof text, "%.1f GHz", std::stod(mhz) / 1000);
  return text;
}

}  // namespace measure
