// SPDX-License-Identifier: MIT-0
#include "measure/times.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "folder.h"

using Catch::Matchers::Message;

TEST_CASE("Quartiles are where they should be, in odd numbers and in even ones") {
  const measure::Quartiles five = measure::quartiles({50, 10, 40, 20, 30});
  CHECK(five.lower == 20);
  CHECK(five.median == 30);
  CHECK(five.upper == 40);
  const measure::Quartiles two = measure::quartiles({3, 1});
  CHECK(two.lower == 1.5);
  CHECK(two.median == 2);
  CHECK(two.upper == 2.5);
  CHECK(measure::quartiles({7}).upper == 7);
}

TEST_CASE("Times are taken in turn") {
  std::string order;
  const auto letter = [&](char c) {
    return [&order, c] {
      order += c;
      return 1e-9 * static_cast<double>(order.size());
    };
  };
  const measure::Times times =
      measure::take_times({{"a", letter('a')}, {"b", letter('b')}}, "none", 3);
  CHECK(order == "ababab");
  CHECK(std::abs(times.at("a").median - 3) < 1e-12);  // of 1, 3 and 5 ns
  CHECK(std::abs(times.at("b").upper - 5) < 1e-12);
  CHECK_THROWS_AS(times.at("c"), std::out_of_range);
}

TEST_CASE("What is written of times is read again") {
  const Folder folder;
  measure::Times times{"a processor: fast", "3.1 GHz", "a compiler", "2026-11-22", 31, 0.01, {}};
  times.of["shuttle/Yoshida 4"] = {1.25, 2.5, 5};
  measure::write_times(times, folder.path / "times.csv");
  const measure::Times again = measure::read_times(folder.path / "times.csv");
  CHECK(again.processor == times.processor);
  CHECK(again.clock == times.clock);
  CHECK(again.compiler == times.compiler);
  CHECK(again.date == times.date);
  CHECK(again.runs == 31);
  CHECK(again.others == times.others);
  CHECK(again.at("shuttle/Yoshida 4").lower == 1.25);
  CHECK(again.at("shuttle/Yoshida 4").upper == 5);
}

TEST_CASE("A file of times that can't be read, or written, or holds something else, is named") {
  const Folder folder;
  const std::string file = (folder.path / "times.csv").string();
  CHECK_THROWS_MATCHES(measure::read_times(file), std::runtime_error,
                       Message("can't read " + file));
  std::ofstream(file) << "name,lower,median,upper\nshuttle,1,2\n";
  CHECK_THROWS_MATCHES(measure::read_times(file), std::runtime_error,
                       Message(file + ": no time in the line: shuttle,1,2"));
  const std::string nowhere = (folder.path / "no" / "times.csv").string();
  CHECK_THROWS_MATCHES(measure::write_times({}, nowhere), std::runtime_error,
                       Message("can't write " + nowhere));
  measure::Times of_a_comma;
  of_a_comma.of["drag, divided"] = {};
  CHECK_THROWS_MATCHES(measure::write_times(of_a_comma, folder.path / "b.csv"), std::runtime_error,
                       Message("a time has a comma in its name: drag, divided"));
}

TEST_CASE("Times were taken alone if other programs took less than a twentieth of a processor") {
  measure::Times times;
  CHECK(times.alone());
  times.others = 0.06;
  CHECK_FALSE(times.alone());
}

TEST_CASE("A program that works beside others is noticed") {
  // A shell that counts for longer than this takes.
  const measure::Timed slow{
      "slow",
      [] { return std::system("i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done") * 0.0; }};
  CHECK_FALSE(measure::take_times({slow}, "none", 3).alone());
}
