// SPDX-License-Identifier: MIT-0
/// @file
/// What is often made of a table.
#pragma once
#include <string>
#include <vector>

#include "../table.h"

namespace judge::any_table {

enum class Slip { piled_up, last_slope_only, last_time_only, velocity_of_the_start };

inline Method with_slip(const std::string& name, const Table& table, Slip slip) {
  return method(
      name, [table, slip](Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
        std::vector<State> slopes;
        State stage{x, v};
        for (const std::vector<double>& row : table.parts) {
          if (slip != Slip::piled_up) stage = {x, v};
          double time = t;
          for (std::size_t j = 0; j < row.size(); ++j) {
            if (slip == Slip::last_slope_only) stage = {x, v};
            if (slip == Slip::last_time_only) time = t;
            stage.x += h * row[j] * (slip == Slip::velocity_of_the_start ? v : slopes[j].x);
            stage.v += h * row[j] * slopes[j].v;
            time += h * row[j];
          }
          slopes.push_back({stage.v, acceleration(stage.x, stage.v, time)});
        }
        for (std::size_t i = 0; i < slopes.size(); ++i) {
          x += h * table.weights[i] * slopes[i].x;
          v += h * table.weights[i] * slopes[i].v;
        }
      });
}

inline std::vector<Method> slips(const Table& table) {
  const std::string name = "the table's method with ";
  return {
      with_slip(name + "stages that pile up: each begins where the one before it ended", table,
                Slip::piled_up),
      with_slip(name + "stages that go along the last of their slopes alone", table,
                Slip::last_slope_only),
      with_slip(name + "a clock that counts the last number of a row alone", table,
                Slip::last_time_only),
      with_slip(name + "stages that move with the velocity of the start", table,
                Slip::velocity_of_the_start),
  };
}

}  // namespace judge::any_table
