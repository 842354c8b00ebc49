// SPDX-License-Identifier: MIT-0
#include "measure/path.h"

#include <catch2/catch_test_macros.hpp>
#include <sstream>

#include "folder.h"
#include "made_up.h"
#include "measure/methods/euler.h"

TEST_CASE("A path has one row for the start and one for each step") {
  const Folder folder;
  measure::Record record;
  measure::path(record, "drift", measure::euler, made_up::Drifter(), 0.25, 1);
  record.write(folder.path);
  CHECK(folder.read("drift.csv") == "t,x,v\n0,0,1\n0.25,0.25,1\n0.5,0.5,1\n0.75,0.75,1\n1,1,1\n");
}

TEST_CASE("An exact path goes from the start to the end in 300 parts") {
  const Folder folder;
  measure::Record record;
  measure::exact_path(record, "drift", made_up::Drifter(), 600);
  record.write(folder.path);
  std::istringstream lines(folder.read("drift.csv"));
  std::string line;
  std::getline(lines, line);
  CHECK(line == "t,x,v");
  for (int n = 0; n <= 300; ++n) {
    std::getline(lines, line);
    CHECK(line == std::to_string(2 * n) + "," + std::to_string(2 * n) + ",1");
  }
  CHECK_FALSE(std::getline(lines, line));
}
