// SPDX-License-Identifier: MIT-0
#include "choose/progress.h"

#include <catch2/catch_test_macros.hpp>
#include <chrono>
#include <cstdio>
#include <initializer_list>
#include <string>

namespace {

/// A clock that stands still until it is set.
struct SetClock {
  using duration = std::chrono::milliseconds;
  using time_point = std::chrono::time_point<SetClock, duration>;
  inline static time_point at{};
  static time_point now() { return at; }
};

/// What is written when something is told at each of these times [ms].
std::string told_at(std::initializer_list<long> times, bool terminal) {
  std::FILE* const file = std::tmpfile();
  REQUIRE(file);
  {
    SetClock::at = {};
    Progress<SetClock> progress(file, terminal);
    for (const long time : times) {
      SetClock::at = SetClock::time_point(SetClock::duration(time));
      progress("at " + std::to_string(time));
    }
  }
  std::rewind(file);
  std::string text;
  for (int letter = std::fgetc(file); letter != EOF; letter = std::fgetc(file))
    text += char(letter);
  std::fclose(file);
  return text;
}

}  // namespace

TEST_CASE("Nobody is told anything within the first two seconds") {
  CHECK(told_at({0, 1000, 1999}, true).empty());
  CHECK(told_at({0, 1000, 1999}, false).empty());
}

TEST_CASE("A terminal has one line that is written again, ten times a second at most, and wiped") {
  CHECK(told_at({2000, 2050, 2101}, true) ==
        "\r\033[Kchoose: 2 s, at 2000\r\033[Kchoose: 2 s, at 2101\r\033[K");
}

TEST_CASE("A file has whole lines, each at twice the time of the one before") {
  CHECK(told_at({2000, 3999, 4000, 7000, 8000}, false) ==
        "choose: 2 s, at 2000\nchoose: 4 s, at 4000\nchoose: 8 s, at 8000\n");
}
