// SPDX-License-Identifier: MIT-0
/// @file
/// The last scene of chapter 6: the outer planets, by every method at the same price.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "../cast_of_many.h"
#include "measure/compiled.h"
#include "measure/record.h"
#include "measure/run.h"

/// The outer solar system with all its unknowns in one column, as the implicit methods want it.
struct Planets {
  using System = scenes::OuterSolarSystem<>;
  using Vec = Eigen::VectorXd;
  System system = outer_planets;

  static Vec column(const System::Vec& x) { return x.reshaped(); }
  static System::Vec bodies(const Vec& x) { return x.reshaped(3, System::bodies); }
  static Eigen::Vector3d body(const Vec& x, int i) { return x.segment<3>(3 * i); }

  Vec operator()(const Vec& x, const Vec& v, double t) const {
    return column(system(bodies(x), bodies(v), t));
  }

  scenes::State<Vec> start() const {
    const auto s = system.start();
    return {column(s.x), column(s.v)};
  }

  double energy(const Vec& x, const Vec& v) const { return system.energy(bodies(x), bodies(v)); }

  template <class Add>
  void jacobian(const Vec& x, const Vec&, double, Add&& add) const {
    for (int i = 0; i < System::bodies; ++i) {
      for (int j = 0; j < System::bodies; ++j) {
        if (i == j) continue;
        const Eigen::Vector3d d = body(x, j) - body(x, i);
        const double r = d.norm();
        const Eigen::Vector3d toward = d / r;
        const Eigen::Matrix3d tide =
            (System::G * System::masses[j] / (r * r * r)) *
            (3 * toward * toward.transpose() - Eigen::Matrix3d::Identity());
        for (int row = 0; row < 3; ++row) {
          for (int k = 0; k < 3; ++k) {
            add(3 * i + row, 3 * i + k, tide(row, k), 0.0);
            add(3 * i + row, 3 * j + k, -tide(row, k), 0.0);
          }
        }
      }
    }
  }
};

constexpr double all_days = 200'000;
constexpr long evaluations = 12'000;  ///< that every method may ask for
constexpr int jupiter = 1;

/// Where the planets really end, as near as very short steps of a good method show it.
inline Planets::Vec true_end() {
  const Planets planets;
  return measure::after(method::dopri5, planets, planets.start(), 5.0, 40'000).x;
}

/// What became of the planets under one method.
struct Fate {
  double largest = 0;        ///< largest relative error of the energy
  double jupiter_off = NAN;  ///< distance of Jupiter from where it should be at the end [AU]
  double fall = NAN;         ///< day on which Jupiter came within one AU of the sun, if it did
};

/// Runs all the days, unless a step has no solution.
/// @param observe  called as `observe(day, largest error of the energy so far)`
template <class Observe>
Fate fate(const measure::Method& method, double h, const Planets::Vec& truth, Observe observe) {
  const Planets planets;
  Fate found;
  auto s = planets.start();
  const double energy = planets.energy(s.x, s.v);
  try {
    measure::run(
        method, planets, s, h, std::lround(all_days / h), [&](double day, const auto& now) {
          const double error = std::abs(planets.energy(now.x, now.v) / energy - 1);
          if (!(error <= found.largest)) found.largest = error;
          const double apart = (planets.body(now.x, jupiter) - planets.body(now.x, 0)).norm();
          if (apart < 1 && !(found.fall <= day)) found.fall = day;
          observe(day, found.largest);
        });
    found.jupiter_off = (planets.body(s.x, jupiter) - planets.body(truth, jupiter)).norm();
  } catch (const std::runtime_error&) {
    found.largest = NAN;  // it fell into the sun
  }
  return found;
}

/// Days at which the figure shows a method, evenly on a logarithmic scale.
inline std::vector<double> looks() {
  std::vector<double> days;
  for (int i = 0; i <= 60; ++i) days.push_back(200 * std::pow(all_days / 200, i / 60.0));
  return days;
}

inline void planets(measure::Record& record) {
  const auto truth = true_end();
  const auto days = looks();
  auto& table = record.table(
      "planets",
      {{"method"}, {"step", "d"}, {"largest energy error"}, {"Jupiter is off by", "AU"}});
  std::vector<measure::Column> columns{{"year"}};
  std::vector<std::vector<measure::Cell>> rows;
  for (const double day : days) rows.push_back({day / 365.25});

  const auto tell = [&](const std::string& name, const measure::Method& method,
                        int evaluations_per_step) {
    const double h = all_days / evaluations * evaluations_per_step;
    std::vector<double> course;
    const Fate found = fate(method, h, truth, [&](double day, double largest) {
      while (course.size() < days.size() && days[course.size()] < day + h / 2) {
        course.push_back(largest);
      }
    });
    course.resize(days.size(), NAN);
    columns.push_back({name});
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(course[i]);
    table.add({name, h, found.largest, found.jupiter_off});
    return found;
  };
  tell("Euler", method::euler, 1);
  const Fate fallen = tell("backward Euler", method::backward_euler_newton, 1);
  record.number("fall-year", fallen.fall / 365.25, 2);
  const Fate hundred = fate(method::symplectic_euler, 100.0, truth, [](double, double) {});
  record.number("hundred-days", 100 * hundred.largest, 2, "%");
  record.number("years", all_days / 365.25, 3);
  tell("midpoint", method::midpoint, 2);
  tell("Heun", method::heun, 2);
  tell("symplectic Euler", method::symplectic_euler, 1);
  tell("symplectic Euler from half a kick back", method::leapfrog, 1);
  tell("velocity Verlet", method::velocity_verlet, 1);
  tell("trapezoid rule", method::trapezoid_newton, 1);
  tell("RK4", method::rk4, 4);
  tell("Yoshida 4", method::yoshida4, 3);
  tell("Dormand-Prince 5", method::dopri5, 6);

  auto& centuries = record.table("centuries", columns);
  for (const auto& row : rows) centuries.add(row);
}
