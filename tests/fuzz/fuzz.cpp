// SPDX-License-Identifier: MIT-0
// Feeds every header of code/integrate and code/shelf what no game means to have, and watches that
// it comes back, does nothing undefined and keeps its promises.   tests.fuzz [case [input]]
#include "fuzz.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <set>

namespace {

constexpr int inputs = 12'000;
constexpr unsigned longest = 10;  // [s] that one input may take

// What is tried just now, for the alarm and for what a sanitizer stops.
char now[200];

void tell_what_hangs(int) {
  const char hangs[] = "does not return: ";
  (void)!write(2, hangs, sizeof hangs - 1);
  (void)!write(2, now, std::strlen(now));
  _exit(1);
}

void tell_where() {
  std::fputs(now, stderr);
}

bool try_all(const fuzz::Case& one, int first, int last) {
  for (int input = first; input < last; ++input) {
    std::snprintf(now, sizeof now, "%s.h: %s, input %d\n", one.header.c_str(), one.name.c_str(),
                  input);
    alarm(longest);
    fuzz::Source source{std::uint64_t(input)};
    try {
      one.once(source);
    } catch (const std::exception& broken) {
      std::fprintf(stderr, "%s is not kept: %s", broken.what(), now);
      return false;
    }
  }
  return true;
}

std::set<std::string> headers() {
  std::set<std::string> found;
  for (const char* folder : {CODE "/integrate", CODE "/shelf"}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      found.insert(entry.path().stem());
  }
  return found;
}

bool all_are_tried(const std::set<std::string>& tried) {
  const std::set<std::string> there = headers();
  for (const std::string& header : there) {
    if (tried.count(header)) continue;
    std::fprintf(stderr, "nothing of %s.h is tried; add a case to tests/fuzz\n", header.c_str());
  }
  for (const std::string& header : tried) {
    if (there.count(header)) continue;
    std::fprintf(stderr, "%s.h is tried, and is not there\n", header.c_str());
  }
  return there == tried;
}

}  // namespace

extern "C" void __sanitizer_set_death_callback(void (*)(void));

int main(int argc, char** argv) {
  signal(SIGALRM, tell_what_hangs);
  __sanitizer_set_death_callback(tell_where);
  fuzz::Cases cases;
  for (const auto& some :
       {fuzz::methods(), fuzz::implicit_methods(), fuzz::systems(), fuzz::adaptive(),
        fuzz::springs(), fuzz::bounces(), fuzz::links(), fuzz::followers(), fuzz::bodies()}) {
    cases.insert(cases.end(), some.begin(), some.end());
  }
  bool good = true;
  std::set<std::string> tried;
  for (const fuzz::Case& one : cases) {
    tried.insert(one.header);
    const std::string name = one.header + ".h: " + one.name;
    if (argc > 1 && name.find(argv[1]) == std::string::npos) continue;
    const int first = argc > 2 ? std::atoi(argv[2]) : 0;
    good = try_all(one, first, argc > 2 ? first + 1 : inputs) && good;
  }
  return all_are_tried(tried) && good ? EXIT_SUCCESS : EXIT_FAILURE;
}
