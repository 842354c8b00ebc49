// SPDX-License-Identifier: MIT-0
/// @file
/// A camera on a spring that is fast for its thirty steps a second, under every method of the map.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "../cast.h"
#include "map.h"
#include "measure/record.h"

inline constexpr double camera_step = 1.0 / 30;  ///< [s]
inline constexpr long camera_steps = 30;

/// Every method of the map, with where it has the camera after each step.
inline std::vector<std::pair<std::string, std::vector<double>>> camera_paths() {
  std::vector<std::pair<std::string, std::vector<double>>> found;
  for (const Mapped& one : mapped) {
    auto& [method, way] = found.emplace_back(one.name, std::vector<double>());
    auto s = camera.start();
    measure::run(one.method, camera, s, camera_step, camera_steps,
                 [&](double, const auto& now) { way.push_back(now.x); });
  }
  return found;
}

inline void your_spring(measure::Record& record) {
  const auto ways = camera_paths();
  std::vector<measure::Column> columns{{"t", "s"}};
  for (const auto& [method, way] : ways) columns.push_back({method, "m"});
  record.number("camera-watched", camera_steps * camera_step, 1, "s");
  auto& table = record.table("your-spring", columns);
  for (std::size_t n = 0; n <= std::size_t(camera_steps); ++n) {
    std::vector<measure::Cell> row{double(n) * camera_step};
    for (const auto& [method, way] : ways) row.push_back(way[n]);
    table.add(row);
  }
}
