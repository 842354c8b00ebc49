// SPDX-License-Identifier: MIT-0
/// @file
/// A method on one card: its order, cost and limits, all measured.
#pragma once
#include <cstdio>
#include <string>

#include "measure/cost.h"
#include "measure/order.h"
#include "measure/record.h"
#include "measure/stability.h"
#include "scenes/circle.h"
#include "scenes/linear_drag.h"
#include "scenes/spring.h"

namespace measure {

/// Keeps the card of a method as table NAME, with the columns "asked" and "measured".
///
/// The last row is a time and names the machine, so no two runs of it agree.
///
/// @param record  gets the table
/// @param name  of the table
/// @param step  a method, called as `step(x, v, t, h, scene)`
/// @returns  the table, for rows that only this method has
template <class Step>
Table& card(Record& record, const std::string& name, Step step) {
  const auto written = [](const char* form, double value) {
    char line[40];
    std::snprintf(line, sizeof line, form, value);
    return std::string(line);
  };
  const scenes::Circle<> circle;
  const scenes::LinearDrag<> braking{.c = 1, .g = 0};
  const scenes::Spring<> damped{.zeta = 0.5};
  const Halving order = halvings(step, circle, 1.0 / 64, 6.0, 3).back();
  const auto evaluations = double(evaluations_per_step(step, circle, 0.01));
  const double growth = spectral_radius(step, scenes::Spring<>{}, 0.1);

  Table& table = record.table(name, {{"asked"}, {"measured"}});
  table.add({"order in position", written("%.2f", order.position_order)});
  table.add({"order in velocity", written("%.2f", order.velocity_order)});
  table.add({"evaluations of the acceleration per step", written("%.0f", evaluations)});
  table.add({"drag: stable while ch is under",
             written("%.3f", stability_limit(step, braking, 1e-6, 10))});
  table.add({"spring with ζ = 0.5: stable while hω is under",
             written("%.3f", stability_limit(step, damped, 1e-6, 10))});
  table.add({"undamped spring: energy after a step of hω = 0.1",
             written("%.9g of what it was", growth * growth)});
  table.add({"time of one step on a circle, on " + machine(),
             written("%.1f ns", 1e9 * seconds_per_step(step, circle, 0.01))});
  return table;
}

}  // namespace measure
