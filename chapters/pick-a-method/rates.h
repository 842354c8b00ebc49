// SPDX-License-Identifier: MIT-0
/// @file
/// How many steps a swing a method needs: so as not to explode, and to stay near the truth.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <utility>
#include <vector>

#include "measure/compiled.h"
#include "measure/longest_stable_step.h"
#include "measure/record.h"
#include "measure/run.h"
#include "scenes/orbit.h"
#include "scenes/spring.h"

/// A method that the page ends in, and whether dampers are among its forces.
struct Answer {
  const measure::Method& method;
  bool damped;
};

/// All of them but the exact and the adaptive steps, whose length is no question, and that of
/// ropes, which have no swing to count by.
inline constexpr Answer answers[] = {{method::symplectic_euler, false},
                                     {method::linear_damping_implicit_last, true},
                                     {method::yoshida4, false},
                                     {method::velocity_verlet, false},
                                     {method::rk4, true},
                                     {method::backward_euler_spring, true},
                                     {method::backward_euler, true},
                                     {method::bdf2, true}};

inline constexpr double watched = 10;                        ///< how long, in swings
inline constexpr double tolerances[] = {0.1, 0.01, 0.001};   ///< shares of the swing
inline constexpr double dampings[] = {0, 0.1, 0.3, 0.6, 1};  ///< of the springs, up to critical

/// The damping ratios that an answer has to cope with.
inline std::vector<double> dampings_of(const Answer& answer) {
  if (!answer.damped) return {0};
  return {std::begin(dampings), std::end(dampings)};
}

/// The longest step that is stable on every spring of an answer, times omega; infinite from 1000
/// on.
inline double limit_of(const Answer& answer) {
  double least = INFINITY;
  for (const double zeta : dampings_of(answer)) {
    least = std::min(least,
                     measure::longest_stable_step(answer.method, scenes::Spring<>{.zeta = zeta}));
  }
  return least;
}

/// The largest error of a method on a spring within the time that is watched, as a share of the
/// swing, from whatever place of the swing it starts.
///
/// On a spring an error is a sum of two, those of a start at rest and of a start in the middle, and
/// the worst start between them is as far off as a triangle of the two is long.
inline double max_relative_error(const measure::Method& method, double zeta, double steps_a_swing) {
  const double h = 2 * std::numbers::pi / steps_a_swing;
  const long steps = std::lround(std::floor(watched * steps_a_swing));
  const auto errors = [&](const scenes::Spring<>& spring) {
    std::vector<double> found;
    auto s = spring.start();
    measure::run(method, spring, s, h, steps,
                 [&](double t, const auto& now) { found.push_back(now.x - spring.exact(t).x); });
    return found;
  };
  const auto at_rest = errors({.zeta = zeta, .x0 = 1, .v0 = 0});
  const auto in_the_middle = errors({.zeta = zeta, .x0 = 0, .v0 = 1});
  double most = 0;
  for (std::size_t n = 0; n < at_rest.size(); ++n) {
    const double worst = std::hypot(at_rest[n], in_the_middle[n]);
    if (!(worst <= most)) most = worst;
  }
  return most;
}

/// A number of steps in two digits, and no fewer steps.
inline double rounded_up(double steps) {
  const double last = std::pow(10, std::floor(std::log10(steps)) - 1);
  return std::ceil(steps / last) * last;
}

/// Steps a swing so as not to explode: twice as many as at the limit; 0 if there is none.
inline double steps_to_stand(const Answer& answer) {
  const double limit = limit_of(answer);
  return limit < INFINITY ? rounded_up(2 * 2 * std::numbers::pi / limit) : 0;
}

/// The fewest steps that are enough, to a hundredth of them.
template <class Within>
double fewest(const Within& within) {
  double few = 2, enough = few;
  while (!within(enough)) few = enough, enough = 2 * enough;
  while (enough - few > std::max(1.0, enough / 100)) {
    const double middle = std::floor((few + enough) / 2);
    (within(middle) ? enough : few) = middle;
  }
  return enough;
}

/// Steps a swing to stay within a tolerance on one spring.
inline double steps_within(const Answer& answer, double zeta, double tolerance) {
  return fewest(
      [&](double steps) { return max_relative_error(answer.method, zeta, steps) <= tolerance; });
}

/// Steps a swing to stay within a tolerance on every spring of an answer, and not to explode.
inline double steps_within(const Answer& answer, double tolerance) {
  double most = 0;
  for (const double zeta : dampings_of(answer)) {
    most = std::max(most, steps_within(answer, zeta, tolerance));
  }
  return std::max(rounded_up(most), steps_to_stand(answer));
}

/// The methods that the page ends in for what orbits.
inline constexpr const measure::Method* of_orbits[] = {&method::yoshida4, &method::velocity_verlet};

/// The orbits that they are asked for.
struct Shape {
  const char* name;
  double eccentricity;
};
inline constexpr Shape shapes[] = {{"circle", 0}, {"e = 0.5", 0.5}};

/// The largest error of a method on an orbit within so many turns, as a share of half its long
/// axis, from eight places of it.
inline double max_relative_error_on_orbit(const measure::Method& method, double eccentricity,
                                          double steps_a_turn, double turns = watched) {
  const scenes::Orbit<> orbit{.eccentricity = eccentricity};
  const double h = orbit.period() / steps_a_turn;
  double most = 0;
  for (int eighth = 0; eighth < 8; ++eighth) {
    const double since = orbit.period() * eighth / 8;
    auto s = orbit.exact(since);
    measure::run(method, orbit, s, h, std::lround(turns * steps_a_turn),
                 [&](double t, const auto& now) {
                   const double error = (now.x - orbit.exact(since + t).x).norm();
                   if (!(error <= most)) most = error;
                 });
  }
  return most / orbit.semi_major;
}

/// Steps a turn to stay within a tolerance on an orbit.
inline double steps_on_orbit(const measure::Method& method, double eccentricity, double tolerance) {
  return rounded_up(fewest([&](double steps) {
    return max_relative_error_on_orbit(method, eccentricity, steps) <= tolerance;
  }));
}

/// The whole steps in a tick that are at least so many in a swing.
/// @param swings  of the spring, in a second
/// @param ticks  of the game, in a second
inline double steps_a_tick(double steps_a_swing, double swings, double ticks) {
  return std::max(1.0, std::ceil(steps_a_swing * swings / ticks));
}

/// What the page says of an answer, worked out once.
struct Rates {
  double stands;
  std::vector<double> within;  ///< for each tolerance
};

inline Rates rates_of(const Answer& answer) {
  Rates rates{steps_to_stand(answer), {}};
  for (const double tolerance : tolerances) {
    rates.within.push_back(steps_within(answer, tolerance));
  }
  return rates;
}

/// The table that the page is made of, and what it should show for springs and games of all kinds.
inline void rates(measure::Record& record) {
  auto& table = record.table("rates", {{"function"},
                                       {"name"},
                                       {"stands", "", 2},
                                       {"to 10 %", "", 2},
                                       {"to 1 %", "", 2},
                                       {"to 0.1 %", "", 2}});
  auto& shown = record.table("shown", {{"function"},
                                       {"swings", "1/s"},
                                       {"ticks", "1/s"},
                                       {"stands", "", measure::whole},
                                       {"to 10 %", "", measure::whole},
                                       {"to 1 %", "", measure::whole},
                                       {"to 0.1 %", "", measure::whole}});
  for (const Answer& answer : answers) {
    const Rates found = rates_of(answer);
    const auto& within = found.within;
    table.add({answer.method.function, answer.method.name, found.stands, within[0], within[1],
               within[2]});
    for (const auto& [swings, ticks] : {std::pair{0.25, 30.0}, {3.0, 60.0}, {7.5, 144.0}}) {
      const auto steps = [often = swings, rate_of_game = ticks](double rate) {
        return steps_a_tick(rate, often, rate_of_game);
      };
      shown.add({answer.method.function, swings, ticks, steps(found.stands), steps(within[0]),
                 steps(within[1]), steps(within[2])});
    }
  }
}

/// Steps a turn, in the same columns.
inline void orbits(measure::Record& record) {
  auto& table = record.table(
      "orbits",
      {{"function"}, {"orbit"}, {"to 10 %", "", 2}, {"to 1 %", "", 2}, {"to 0.1 %", "", 2}});
  for (const measure::Method* method : of_orbits) {
    for (const Shape& shape : shapes) {
      const auto steps = [&](double tolerance) {
        return steps_on_orbit(*method, shape.eccentricity, tolerance);
      };
      table.add({method->function, shape.name, steps(tolerances[0]), steps(tolerances[1]),
                 steps(tolerances[2])});
    }
  }
}
