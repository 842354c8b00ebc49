// SPDX-License-Identifier: MIT-0
/// @file
/// What is left of a blow in chapter 4, and how often each step is solved for it.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bar.h"
#include "bdf2_spring.h"
#include "integrate/trapezoid.h"
#include "measure/record.h"
#include "parachute.h"
#include "struck.h"

/// One solve of the trapezoid rule.
inline constexpr auto trapezoid_once = [](Struck& s, const auto& scene, auto& system) {
  return integrate::trapezoid(s.x, s.v, 0.0, frame, scene, system);
};

/// The trapezoid rule to the end of Newton's method.
inline constexpr auto trapezoid_to_the_end = [](Struck& s, const auto& scene, auto& system) {
  return integrate::trapezoid_newton(s.x, s.v, 0.0, frame, scene, system, largest, tolerance) > 0;
};

/// Iterations of Newton's method in a step of the trapezoid rule, on average; 0 if one failed.
template <class Scene>
double solves_of_trapezoid(const Scene& scene, double speed, int steps) {
  Struck s = struck(scene, speed);
  auto system = system_of(scene);
  long sum = 0;
  for (int n = 0; n < steps; ++n) {
    const int solves =
        integrate::trapezoid_newton(s.x, s.v, 0.0, frame, scene, system, largest, tolerance);
    if (solves == 0) return 0;
    sum += solves;
  }
  return double(sum) / steps;
}

/// One solve of BDF2, begun with one of backward Euler; for one blow.
inline auto bdf2_once() {
  return [previous = std::optional<Struck>()](Struck& s, const auto& scene, auto& system) mutable {
    const Struck now = s;
    if (previous) {
      s = {(4 * now.x - previous->x) / 3, (4 * now.v - previous->v) / 3};
    }
    const double step = previous ? 2 * frame / 3 : frame;
    previous = now;
    return integrate::backward_euler(s.x, s.v, 0.0, step, scene, system);
  };
}

/// A gentle blow, and what a second leaves of it.
inline void a_second(measure::Record& record) {
  auto& table = record.table("second", {{"t", "s"}, {"chain"}, {"rope"}, {"cloth"}, {"1 Hz"}});
  const auto c = shares(chain, gentle, 60, solved_once), r = shares(rope, gentle, 60, solved_once);
  const auto cl = shares(cloth, gentle, 60, solved_once);
  for (std::size_t n = 0; n <= 60; ++n) {
    const double left = std::pow(left_in_a_step(frame * swinging(1).omega), double(n));
    table.add({frame * double(n), c[n], r[n], cl[n], left});
  }
  record.number("first-chain", 100 * c[1], 2, "%");
  record.number("second-rope", 100 * r[60], 2, "%");
  record.number("second-cloth", 100 * cl[60], 2, "%");
  for (const int times : {1, 2}) {
    record.number("bdf2-" + std::to_string(times) + "hz", 100 * left_by_bdf2(swinging(times).omega),
                  2, "%");
  }
  record.number("bdf2-cloth", 100 * shares(cloth, gentle, 60, bdf2_once()).back(), 2, "%");
  record.number("bdf2-rope", 100 * shares(rope, gentle, 60, bdf2_once()).back(), 2, "%");
  record.number("bdf2-suspension", 100 * left_by_bdf2(suspension.omega), 2, "%");
  const auto left = [](const scenes::Spring<>& spring) {
    return 100 * std::pow(left_in_a_step(frame * spring.omega), 60);
  };
  record.number("second-1hz", left(swinging(1)), 2, "%");
  record.number("second-2hz", left(swinging(2)), 2, "%");
  record.number("second-suspension", left(suspension), 2, "%");
}

/// A hard blow, solved once a step and to the end.
inline void hard_blow(measure::Record& record) {
  auto& blow = record.table(
      "blow", {{"t", "s"}, {"one solve"}, {"to the end"}, {"trapezoid"}, {"trapezoid end"}});
  const auto once = shares(rope, hard, 60, solved_once), end = shares(rope, hard, 60, to_the_end);
  const auto trap = shares(rope, hard, 60, trapezoid_once);
  const auto trap_end = shares(rope, hard, 60, trapezoid_to_the_end);
  for (std::size_t n = 0; n <= 60; ++n) {
    blow.add({frame * double(n), once[n], end[n], trap[n], trap_end[n]});
  }
  record.number("blow-once", *std::max_element(once.begin(), once.end()), 3);
  record.number("blow-end", end[60], 2);
  record.number("blow-trapezoid", trap[60], 2);
  record.number("trapezoid-solves", solves_of_trapezoid(rope, hard, 60), 2);
  const auto cloth_trap = shares(cloth, hard, 60, trapezoid_once);
  record.number("blow-trapezoid-cloth", cloth_trap.back(), 2);
}

/// How much each of Newton's iterations changes in one step.
inline void newton(measure::Record& record) {
  auto& table = record.table("newton", {{"iteration", "", measure::whole},
                                        {"parachute", "m/s", 2},
                                        {"rope, gentle", "m/s", 2},
                                        {"rope, hard", "m/s", 2},
                                        {"cloth, hard", "m/s", 2}});
  const std::vector<double> all[] = {changes_of_parachute(), changes(rope, gentle),
                                     changes(rope, hard), changes(cloth, hard)};
  for (std::size_t n = 0; n < all[3].size(); ++n) {
    std::vector<measure::Cell> row{double(n + 1)};
    for (const auto& one : all) row.push_back(n < one.size() ? one[n] : NAN);
    table.add(row);
  }
  record.number("iterations-parachute", double(all[0].size()), measure::whole);
  record.number("iterations-cloth-hard", double(all[3].size()), measure::whole);
}
