// SPDX-License-Identifier: MIT-0
/// @file
/// Any explicit Runge-Kutta method, by its table.
#pragma once
#include <string>
#include <vector>

#include "judge/method.h"

namespace judge {

struct ButcherTable {
  std::string name;                        ///< of the method
  std::vector<std::vector<double>> parts;  ///< row i, with i numbers, leads to stage i
  std::vector<double> weights;
};

inline Method method_of(const ButcherTable& table) {
  return method(table.name,
                [table](Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
                  std::vector<State> slopes;
                  const auto along = [&](const std::vector<double>& row, State state) {
                    for (std::size_t j = 0; j < row.size(); ++j) {
                      state.x += h * row[j] * slopes[j].x;
                      state.v += h * row[j] * slopes[j].v;
                    }
                    return state;
                  };
                  for (const std::vector<double>& row : table.parts) {
                    double reach = 0;
                    for (const double part : row) reach += part;
                    const State stage = along(row, {x, v});
                    slopes.push_back({stage.v, acceleration(stage.x, stage.v, t + reach * h)});
                  }
                  const State end = along(table.weights, {x, v});
                  x = end.x;
                  v = end.v;
                });
}

}  // namespace judge
