// SPDX-License-Identifier: MIT-0
/// @file
/// The stability map of the damped spring: h omega to the right, zeta upwards.
#pragma once
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "entrants.h"
#include "measure/record.h"
#include "measure/stability.h"
#include "scenes/spring.h"

inline constexpr double widest = 4;   ///< of h omega on the map
inline constexpr double tallest = 2;  ///< of zeta on the map

/// Calls `visit(name, step)` for each method that has a map of its own. On a spring Heun is
/// midpoint, and leapfrog and Störmer–Verlet have the limits of symplectic Euler.
template <class Visit>
void for_each_map(Visit visit) {
  visit("Euler", measure::euler);
  visit("midpoint", measure::midpoint);
  visit("RK4", measure::rk4);
  visit("Dormand-Prince", measure::dopri5);
  visit("symplectic Euler", measure::symplectic_euler);
  visit("drag divided", measure::linear_damping_implicit_last);
  visit("velocity Verlet", measure::velocity_verlet);
  visit("Yoshida 4", measure::yoshida4);
  visit("predicted Euler", measure::predicted_euler<1>);
  visit("trapezoid", measure::trapezoid);
  visit("backward Euler", measure::backward_euler);
  visit("exact step", measure::spring_exact);
}

inline constexpr scenes::Spring<> spring_of(double zeta) {
  return {.omega = 1, .zeta = zeta};
}

/// Whether no start grows for ever.
template <class Step>
bool stable(const Step& step, double homega, double zeta) {
  return measure::spectral_radius(step, spring_of(zeta), homega) <= 1 + 1e-12;
}

// [true]
/// Whether the slow motion, the one that is seen, has its rate and its frequency within a tenth.
template <class Step>
bool true_to_life(const Step& step, double homega, double zeta) {
  using Complex = std::complex<double>;
  const Complex rate = -zeta + std::sqrt(Complex(zeta * zeta - 1));
  double nearest = INFINITY;
  const auto matrix = measure::step_matrix(step, spring_of(zeta), homega);
  for (const Complex& factor : measure::eigenvalues(matrix)) {
    nearest = std::min(nearest, std::abs(std::log(factor / std::exp(homega * rate))));
  }
  return nearest < 0.1 * homega * std::abs(rate);
}
// [true]

/// Up to which h omega something holds, from short steps on: zero if it does not for any, `widest`
/// if it does on all of the map.
template <class Holds>
double holds_until(Holds holds) {
  constexpr double part = 1.0 / 64;
  if (!holds(part)) return 0;
  double last = part;
  for (double next = 2 * part; next <= widest; next += part) {
    if (!holds(next)) {
      for (int halving = 0; halving < 30; ++halving) {
        const double middle = (last + next) / 2;
        (holds(middle) ? last : next) = middle;
      }
      return last;
    }
    last = next;
  }
  return widest;
}

template <class Step>
double stable_until(const Step& step, double zeta) {
  return holds_until([&](double homega) { return stable(step, homega, zeta); });
}

template <class Step>
double true_until(const Step& step, double zeta) {
  return holds_until([&](double homega) {
    return stable(step, homega, zeta) && true_to_life(step, homega, zeta);
  });
}

/// On what part of the map something holds [%].
template <class Holds>
double share(Holds holds) {
  constexpr int parts = 100;
  int inside = 0;
  for (int i = 0; i < parts; ++i) {
    for (int j = 0; j < parts; ++j) {
      inside += holds(widest * (i + 0.5) / parts, tallest * (j + 0.5) / parts);
    }
  }
  return 100.0 * inside / (parts * parts);
}

template <class Step>
double stable_share(const Step& step) {
  return share([&](double homega, double zeta) { return stable(step, homega, zeta); });
}

template <class Step>
double true_share(const Step& step) {
  return share([&](double homega, double zeta) {
    return stable(step, homega, zeta) && true_to_life(step, homega, zeta);
  });
}

inline void stability_map(measure::Record& record) {
  std::vector<measure::Column> columns{{"ζ"}};
  for_each_map([&](const std::string& name, const auto&) {
    columns.push_back({name});
    columns.push_back({name + " true"});
  });
  auto& map = record.table("map", columns);
  for (int i = 0; i <= 50; ++i) {
    const double zeta = tallest * i / 50;
    std::vector<measure::Cell> row{zeta};
    for_each_map([&](const auto&, const auto& step) {
      row.push_back(stable_until(step, zeta));
      row.push_back(true_until(step, zeta));
    });
    map.add(row);
  }

  auto& table = record.table("limits", {{"method"},
                                        {"ζ = 0"},
                                        {"ζ = 0.1"},
                                        {"ζ = 0.5"},
                                        {"ζ = 1"},
                                        {"ζ = 2"},
                                        {"of the map", "%", 2},
                                        {"true on", "%", 2}});
  for_each_map([&](const auto& name, const auto& step) {
    std::vector<measure::Cell> row{name};
    for (const double zeta : {0.0, 0.1, 0.5, 1.0, 2.0}) row.push_back(stable_until(step, zeta));
    row.push_back(stable_share(step));
    row.push_back(true_share(step));
    table.add(row);
  });
  record.number("map-euler", stable_share(measure::euler), 2, "%");
  record.number("map-symplectic", stable_share(measure::symplectic_euler), 2, "%");
  record.number("map-verlet", stable_share(measure::velocity_verlet), 2, "%");
  record.number("map-divided", stable_share(measure::linear_damping_implicit_last), 2, "%");
  record.number("true-symplectic", true_share(measure::symplectic_euler), 2, "%");
  record.number("true-divided", true_share(measure::linear_damping_implicit_last), 2, "%");
  record.number("true-backward", true_share(measure::backward_euler), 2, "%");
}
