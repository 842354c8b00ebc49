// SPDX-License-Identifier: MIT-0
/// @file
/// The cost of the libraries, as tests/peers found it.
#pragma once
#include <string>

#include "measure/record.h"
#include "measure/times.h"

/// The name of the time of a planet alone, or of one of 512.
/// @param called  how, such as `GSL`
inline std::string library_name(const std::string& method, const std::string& called,
                                bool of_many = false) {
  return "library/" + std::string(of_many ? "512 orbits " : "") + method + "/" + called;
}

/// The recorded time of a step of a planet [ns].
inline double library_time(const std::string& method, const std::string& called,
                           bool of_many = false) {
  const auto& times = measure::recorded_times("libraries.csv");
  return times.at(library_name(method, called, of_many)).median;
}

inline void libraries(measure::Record& record) {
  auto& table = record.table("libraries", {{"a step of"},
                                           {"called"},
                                           {"alone", "ns"},
                                           {"by hand = 1", "", 2},
                                           {"one of 512", "ns"},
                                           {"of 512, by hand = 1", "", 2}});
  const auto beside_hand = [](const std::string& method, const std::string& called, bool of_many) {
    return library_time(method, called, of_many) / library_time(method, "by hand", of_many);
  };
  for (const std::string method : {"symplectic_euler", "velocity_verlet", "rk4", "dopri5"}) {
    for (const std::string called : {"by hand", "header struct", "header Vector2d", "odeint array",
                                     "odeint Eigen", "GSL", "SUNDIALS ERKStep"}) {
      const std::string name = library_name(method, called);
      if (!measure::recorded_times("libraries.csv").of.contains(name)) continue;
      table.add({method, called, "time:" + name, beside_hand(method, called, false),
                 "time:" + library_name(method, called, true), beside_hand(method, called, true)});
    }
  }
}
