// SPDX-License-Identifier: MIT-0
/// @file
/// What the libraries cost: the results of tests/peers, where that has been run in this build.
#pragma once
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "measure/machine.h"
#include "measure/record.h"

/// The fields of one line, of which those with a comma stand between quotes.
inline std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> found(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      found.emplace_back();
    } else {
      found.back() += c;
    }
  }
  return found;
}

// [peers]
/// @param speed  the file that the benchmark writes, if it has been run
inline void libraries(measure::Record& record, const std::filesystem::path& speed) {
  auto& table = record.table("libraries", {{"measured"},
                                           {"a step of"},
                                           {"called"},
                                           {"on " + measure::machine(), "ns", 3},
                                           {"by hand = 1", "", 3}});
  const std::set<std::string> methods{"symplectic_euler", "velocity_verlet", "rk4"};
  const std::set<std::string> called{"by hand",         "header, struct", "header, Vector2d",
                                     "odeint, array",   "odeint, Eigen",  "GSL",
                                     "SUNDIALS ERKStep"};
  std::ifstream file(speed);
  std::map<std::string, double> by_hand;
  for (std::string line; std::getline(file, line);) {
    const auto row = fields(line);
    if (row.size() < 4 || row[2] != "-O3 -march=native") continue;
    if (!methods.contains(row[0]) || !called.contains(row[1])) continue;
    const double time = std::stod(row[3]);
    if (row[1] == "by hand") by_hand[row[0]] = time;
    table.add({"time", row[0], row[1], time, time / by_hand[row[0]]});
  }
  if (table.rows.empty()) table.add({"time", "any method", "not run in this build", NAN, NAN});
}
// [peers]
