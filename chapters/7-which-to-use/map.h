// SPDX-License-Identifier: MIT-0
/// @file
/// The stability map of the damped spring: h omega to the right, zeta upwards.
#pragma once
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "../cast.h"
#include "choose/entrants.h"
#include "measure/longest_stable_step.h"
#include "measure/record.h"
#include "measure/stability.h"
#include "scenes/spring.h"
#include "verdicts.h"

inline constexpr double widest = 4;   ///< of h omega on the map
inline constexpr double tallest = 2;  ///< of zeta on the map

/// A method with a map of its own, and what it is called there.
struct Mapped {
  const char* name;
  const measure::Method& method;
};

/// The methods that have a map of their own. On a spring Heun is midpoint, and leapfrog and
/// Störmer–Verlet have the limits of symplectic Euler.
inline constexpr Mapped mapped[] = {
    {"Euler", method::euler},
    {"midpoint", method::midpoint},
    {"RK4", method::rk4},
    {"Dormand-Prince", method::dopri5},
    {"symplectic Euler", method::symplectic_euler},
    {"drag divided", method::linear_damping_implicit_last},
    {"velocity Verlet", method::velocity_verlet},
    {"Yoshida 4", method::yoshida4},
    {"predicted Euler", method::predicted_euler},
    {"trapezoid", method::trapezoid},
    {"backward Euler", method::backward_euler},
    {"BDF2", method::bdf2},
    {"soft constraint", method::backward_euler_spring},
    {"exact step", method::spring_exact},
};

inline constexpr scenes::Spring<> spring_of(double zeta) {
  return {.omega = 1, .zeta = zeta};
}

/// Returns whether the slow motion, the one that is seen, has its rate and its frequency within a
/// tenth.
inline bool accurate_within_ten_percent(const measure::Method& method, double homega, double zeta) {
  using Complex = std::complex<double>;
  const Complex rate = -zeta + std::sqrt(Complex(zeta * zeta - 1));
  double nearest = INFINITY;
  const auto matrix = measure::step_matrix(method, spring_of(zeta), homega);
  for (const Complex& factor : measure::eigenvalues(matrix)) {
    nearest = std::min(nearest, std::abs(std::log(factor / std::exp(homega * rate))));
  }
  return nearest < 0.1 * homega * std::abs(rate);
}

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

inline double stable_until(const measure::Method& method, double zeta) {
  return holds_until(
      [&](double homega) { return measure::is_stable(method, spring_of(zeta), homega); });
}

inline double accurate_until(const measure::Method& method, double zeta) {
  return holds_until([&](double homega) {
    return measure::is_stable(method, spring_of(zeta), homega) &&
           accurate_within_ten_percent(method, homega, zeta);
  });
}

inline void stability_map(measure::Record& record) {
  std::vector<measure::Column> columns{{"ζ"}};
  for (const Mapped& one : mapped) {
    columns.push_back({one.name});
    columns.push_back({one.name + std::string(" true")});
  }
  auto& map = record.table("map", columns);
  for (int i = 0; i <= 50; ++i) {
    const double zeta = tallest * i / 50;
    std::vector<measure::Cell> row{zeta};
    for (const Mapped& one : mapped) {
      row.push_back(stable_until(one.method, zeta));
      row.push_back(accurate_until(one.method, zeta));
    }
    map.add(row);
  }

  auto& table = record.table(
      "limits", {{"method"}, {"ζ = 0"}, {"ζ = 0.1"}, {"ζ = 0.5"}, {"ζ = 1"}, {"ζ = 2"}});
  for (const Mapped& one : mapped) {
    std::vector<measure::Cell> row{one.name};
    for (const double zeta : {0.0, 0.1, 0.5, 1.0, 2.0}) {
      const double limit = stable_until(one.method, zeta);
      limit < widest ? row.push_back(measure::in_three_digits(limit)) : row.push_back("> 4");
    }
    table.add(row);
  }
  auto& dots = record.table("springs-at-sixty", {{"thing"}, {"hω"}, {"ζ"}});
  dots.add({"suspension", frame * suspension.omega, suspension.zeta});
  dots.add({"hatch", frame * hatch.omega, hatch.zeta});
  const auto critical = [&](const char* name, const measure::Method& method) {
    record.number(name, measure::longest_stable_step(method, spring_of(1)), 2);
  };
  critical("critical-euler", method::euler);
  critical("critical-symplectic", method::symplectic_euler);
  critical("critical-verlet", method::velocity_verlet);
  critical("critical-divided", method::linear_damping_implicit_last);
  const auto half_critical = [&](const char* name, const measure::Method& method) {
    record.number(name, accurate_until(method, 0.5), 2);
  };
  half_critical("true-symplectic", method::symplectic_euler);
  half_critical("true-divided", method::linear_damping_implicit_last);
  half_critical("true-backward", method::backward_euler);
}
