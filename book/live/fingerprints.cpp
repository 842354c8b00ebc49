// SPDX-License-Identifier: MIT-0
// Prints the fingerprint of each run that a line of standard input asks for:
//   FIGURE STEPS SETTING=VALUE...
// The value of a choice is its name. Of anything that it does not know it says so, and ends with 2.
#include <cstdio>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "fingerprint.h"

namespace {

std::unique_ptr<live::Figure> make(const std::string& name) {
  for (const live::Entry& entry : live::figures()) {
    if (entry.name == name) return entry.make();
  }
  throw std::invalid_argument("there is no figure \"" + name + "\"");
}

double value_of(const live::Setting& setting, const std::string& text) {
  if (setting.choices.empty()) return std::stod(text);
  for (std::size_t i = 0; i < setting.choices.size(); ++i) {
    if (setting.choices[i] == text) return double(i);
  }
  throw std::invalid_argument("\"" + text + "\" is no choice of " + setting.name);
}

void set(live::Figure& figure, const std::string& assignment) {
  const auto equals = assignment.find('=');
  for (const live::Setting& setting : figure.all_settings()) {
    if (assignment.substr(0, equals) != setting.name || equals == std::string::npos) continue;
    *setting.value = value_of(setting, assignment.substr(equals + 1));
    return;
  }
  throw std::invalid_argument("the figure has no setting of \"" + assignment + "\"");
}

void answer(const std::string& line) {
  std::istringstream words(line);
  std::string name, assignment;
  int steps = 0;
  words >> name >> steps;
  const auto figure = make(name);
  while (words >> assignment) set(*figure, assignment);
  std::printf("%016llx\n", static_cast<unsigned long long>(live::fingerprint(*figure, steps)));
}

}  // namespace

int main() {
  std::string line;
  try {
    while (std::getline(std::cin, line)) answer(line);
  } catch (const std::invalid_argument& fault) {
    std::fprintf(stderr, "fingerprints: %s: %s\n", line.c_str(), fault.what());
    return 2;
  }
}
