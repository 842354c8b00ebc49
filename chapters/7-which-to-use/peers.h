// SPDX-License-Identifier: MIT-0
/// @file
/// What the libraries cost: what tests/peers found.
#pragma once
#include <string>

#include "measure/record.h"
#include "measure/times.h"

/// The recorded time of a step of one planet [ns].
/// @param called  how, such as `GSL`
inline double library_time(const std::string& method, const std::string& called) {
  return measure::recorded_times("libraries.csv").at("library/" + method + "/" + called).median;
}

inline void libraries(measure::Record& record) {
  auto& table = record.table("libraries",
                             {{"a step of"}, {"called"}, {"time", "ns"}, {"by hand = 1", "", 2}});
  for (const std::string method : {"symplectic_euler", "velocity_verlet", "rk4"}) {
    for (const std::string called : {"by hand", "header struct", "header Vector2d", "odeint array",
                                     "odeint Eigen", "GSL", "SUNDIALS ERKStep"}) {
      const std::string name = "library/" + method + "/" + called;
      if (!measure::recorded_times("libraries.csv").of.contains(name)) continue;
      table.add({method, called, "time:" + name,
                 library_time(method, called) / library_time(method, "by hand")});
    }
  }
}
