// SPDX-License-Identifier: MIT-0
// Methods and scenes that are made up so that every measurement has a known answer.
#pragma once
#include <cmath>

#include "scenes/state.h"

namespace made_up {

// A body that nothing pushes, from x = 0 at 1 m/s.
struct Drifter {
  template <class Time>
  double operator()(const double&, const double&, Time) const {
    return 0;
  }
  scenes::State<double> start() const { return {0, 1}; }
  scenes::State<double> exact(double t) const { return {t, 1}; }
};

// A method of known orders: on the drifter, x is wrong by t h^in_x and v by 3 t h^in_v.
inline auto of_orders(int in_x, int in_v) {
  return [in_x, in_v](double& x, double& v, double, double h, const auto&) {
    x = x + h * 1 + h * std::pow(h, in_x);
    v = v + 3 * h * std::pow(h, in_v);
  };
}

// Multiplies the velocity by a factor that depends on the time alone, and does not move.
template <class Factor>
auto scaling(Factor factor) {
  return [factor](double&, double& v, double t, double, const auto&) { v = factor(t) * v; };
}

}  // namespace made_up
