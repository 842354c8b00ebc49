// SPDX-License-Identifier: MIT-0
#include "asked.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "judge/session.h"

namespace ways {
namespace {

// Whether it has no function of numbers, or says harness::any of each of them.
bool says_that_there_are_none(const grade::Exercise& exercise) {
  const std::string text = read(exercise.folder / "harness.h");
  return text.find("harness::Wanted<") == text.npos || text.find("harness::any") != text.npos;
}

// What a solution's drivers said of the arguments that they were given, see watch.h.
struct Asked {
  std::map<std::string, bool> within;  ///< what is to be asked, and whether it was
  std::set<std::string> outside;       ///< what was asked beyond the bounds

  void read(const std::string& printed) {
    std::istringstream lines(printed);
    for (std::string line; std::getline(lines, line);) {
      std::smatch said;
      if (!std::regex_match(line, said, std::regex("(asked|outside) (\\d+) (.*) (yes|no)")))
        continue;
      const std::string which = "harness.h:" + said.str(2) + ": " + said.str(3);
      if (said.str(1) == "asked") within[which] = within[which] || said.str(4) == "yes";
      if (said.str(1) == "outside") outside.insert(which);
    }
  }
  bool all() const {
    return std::ranges::all_of(within, [](const auto& one) { return one.second; });
  }
};

}  // namespace

bool asks_all(const Grade& grade, const grade::Exercise& exercise) {
  Asked asked;
  for (std::uint64_t seed = 1; seed == 1 || (seed <= 3 && !asked.all()); ++seed) {
    grade(exercise.folder / "solution.h", seed, "");
    asked.read(judge::session().printed);
  }
  for (const auto& which : asked.outside)
    std::printf("WRONG  %s lies outside of its bounds, and is asked\n", which.c_str());
  for (const auto& [which, was] : asked.within)
    if (!was) std::printf("WRONG  %s is never asked\n", which.c_str());
  const bool says_something = !asked.within.empty() || says_that_there_are_none(exercise);
  if (!says_something)
    std::printf("WRONG  harness.h says of no argument what may be asked, nor harness::any\n");
  return asked.outside.empty() && asked.all() && says_something;
}

}  // namespace ways
