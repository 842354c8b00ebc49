// SPDX-License-Identifier: MIT-0
/// @file
/// Order two, from the errors of places alone: position Verlet's velocity has another order.
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "format_values.h"
#include "judge/session.h"

namespace judge::verlet {

/// Four runs, each with steps half as long as the one before.
struct Halvings {
  std::string asked, input;
  std::vector<double> steps;   ///< their lengths [s]
  std::vector<double> errors;  ///< of the places [m]
  std::string hint_if_one;     ///< for a method of order one
  std::string hint_if_none;    ///< for one whose error stays
};

/// Checks that the last halving divides the error by four, and so does the one before.
inline void has_order_two(const Halvings& runs) {
  constexpr double within = 0.1;
  const std::vector<double>&h = runs.steps, &errors = runs.errors;
  const double order = std::log2(errors[2] / errors[3]);
  const double before = std::log2(errors[1] / errors[2]);
  grade::Finding finding;
  finding.held = std::abs(order - 2) <= within && std::abs(order - before) <= within;
  finding.asked = "order two: " + runs.asked;
  finding.input = runs.input;
  finding.expected = "half the step divides the error by 4";
  finding.got = "errors";
  for (const double error : errors) finding.got += " " + grade::number(error, 3);
  finding.got += " m";
  finding.error = "order " + grade::number(order, 3) + " instead of 2";
  finding.tolerance = grade::number(within);
  finding.tolerance_from =
      "successive estimates of the right formula differ by less at these steps";
  if (!finding.held) {
    finding.hint = std::abs(order - 1) < 0.5 ? runs.hint_if_one : runs.hint_if_none;
    finding.plot = {
        "Error and step", "longest step [s]", "largest error [m]", {{"yours", h, errors}}};
    finding.plot.curves.push_back({"order 2", h, {}});
    for (const double step : h) {
      finding.plot.curves[1].y.push_back(errors[0] * (step / h[0]) * (step / h[0]));
    }
    finding.plot.logarithmic = true;
  }
  check(finding);
}

}  // namespace judge::verlet
