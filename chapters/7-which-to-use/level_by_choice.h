// SPDX-License-Identifier: MIT-0
/// @file
/// The level again, each thing with what the contest chooses for it, and one example in full.
#pragma once
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "choose/contests.h"
#include "choose/entrants.h"
#include "choose/reasons.h"
#include "level.h"
#include "measure/record.h"
#include "position_error.h"

inline constexpr double centimetre = 0.01;  ///< the largest error that the level may show [m]

/// The contest for each thing of the level, to a distance [m]; worked out once.
inline const std::map<std::string, Contest>& contests_to_within(double distance) {
  static std::map<double, std::map<std::string, Contest>> known;
  auto& found = known[distance];
  if (!found.empty()) return found;
  for_each_thing([&](const std::string& thing, const auto& scene, double seconds) {
    Bounds bounds{.seconds = seconds};
    bounds.error = distance / size_of(scene, bounds);
    found[thing] = contest(scene, bounds);
  });
  return found;
}

/// The entry that the contest would take: the exact step, if there is one.
inline const Entry& taken(const Contest& found) {
  return found.exact.empty() ? found.methods.front() : found.exact.front();
}

/// Evaluations a second for the whole level, each thing with what the contest would take.
inline double total_to_within(double distance) {
  double total = 0;
  for (const auto& [thing, found] : contests_to_within(distance)) {
    total += taken(found).evaluations;
  }
  return total;
}

/// The time of an entry for a second of a thing, of one of many bodies in a loop [ns].
inline double time_of(const std::string& thing, const Entry& entry) {
  return double(entry.last.substeps) / frame * step_time(thing, in_a_loop, *entry.method);
}

/// The time of each method for a second of the level, every thing with as many steps as it needs
/// [ns];
/// infinite if one of them is never good enough, NaN if a time is not recorded. Of one of many
/// bodies in a loop.
inline std::map<std::string, double> times_alone() {
  std::map<std::string, double> all;
  for (const auto& [thing, found] : contests_to_within(centimetre)) {
    for (const Entry& entry : found.methods) {
      all[entry.name] += entry.good ? time_of(thing, entry) : INFINITY;
    }
  }
  return all;
}

/// The time for a second of the level with the entry that the contest would take for each thing
/// [ns].
inline double time_of_choice() {
  double total = 0;
  for (const auto& [thing, found] : contests_to_within(centimetre)) {
    total += time_of(thing, taken(found));
  }
  return total;
}

inline void level_again(measure::Record& record) {
  auto& table = record.table("solved", {{"thing"},
                                        {"take"},
                                        {"header"},
                                        {"steps a frame", "", measure::whole},
                                        {"evaluations a second", "", measure::whole},
                                        {"off", "cm", 2}});
  double total = 0;
  std::map<std::string, double> alone;
  for_each_thing([&](const auto& name, const auto& scene, double seconds) {
    const Contest& found = contests_to_within(centimetre).at(name);
    const Entry& best = taken(found);
    total += best.evaluations;
    table.add({name, best.name, best.method->header, double(best.last.substeps), best.evaluations,
               or_rounding(100 * best.last.error * size_of(scene, Bounds{.seconds = seconds}))});
    for (const Entry& entry : found.methods) {
      alone[entry.name] += entry.good ? entry.evaluations : INFINITY;
    }
  });
  record.number("chosen-total", total, measure::whole);
  record.number("verlet-times", alone["velocity Verlet"] / total, 2);
  record.number("symplectic-times", alone["symplectic Euler"] / total, 2);
  auto& bills = record.table("bills", {{"method"}, {"evaluations a second", "", measure::whole}});
  bills.add({"the choice for each", total});
  std::vector<std::pair<double, std::string>> sorted;
  for (const measure::Method* method : entrants) {
    const std::string name(method->name);
    sorted.emplace_back(alone[name], name);
  }
  std::sort(sorted.begin(), sorted.end());
  for (const auto& [bill, name] : sorted) bills.add({name, bill});
  record.number("chosen-time", 1e-3 * time_of_choice(), 2, "µs");
  auto times = times_alone();
  record.number("verlet-time", 1e-3 * times["velocity Verlet"], 2, "µs");
  record.number("symplectic-time", 1e-3 * times["symplectic Euler"], 2, "µs");
  record.number("chosen-share", 100 * 1e-9 * 1000 * time_of_choice(), 1, "%");
  record.number("millimetre-total", total_to_within(centimetre / 10), measure::whole);
  record.number("leapfrog-total", alone["leapfrog"], measure::whole);
  record.number("rk4-total", alone["RK4"], measure::whole);
  record.number("verlet-total", alone["velocity Verlet"], measure::whole);
  record.number("symplectic-total", alone["symplectic Euler"], measure::whole);
}

/// The question `choose --scene spring --omega 40 --zeta 0.1 --hz 60 --error 0.01`.
inline constexpr scenes::Spring<> example{.omega = 40, .zeta = 0.1};
inline const Bounds example_bounds{.hz = 60, .error = 0.01};

/// The swing of the exercise, twice a second.
inline constexpr scenes::Spring<> twice_a_second = swinging(2);

inline void example_choice(measure::Record& record) {
  auto& table = record.table("choice", {{"function"},
                                        {"steps a frame", "", measure::whole},
                                        {"evaluations a second", "", measure::whole},
                                        {"error", "", 2},
                                        {"with fewer steps"}});
  const Contest found = contest(example, example_bounds);
  record.number("example-times",
                entry_of(found, method::symplectic_euler).evaluations /
                    entry_of(found, method::rk4).evaluations,
                2);
  const Contest swing = contest(twice_a_second, example_bounds);
  record.number("by-hand-rk4", entry_of(swing, method::rk4).evaluations, measure::whole);
  record.number("by-hand-verlet", entry_of(swing, method::velocity_verlet).evaluations,
                measure::whole);
  const auto add = [&](const Entry& entry) {
    table.add({entry.method->function, double(entry.last.substeps), entry.evaluations,
               or_rounding(entry.last.error), reason(entry, example_bounds)});
  };
  for (const Entry& entry : found.exact) add(entry);
  for (const Entry& entry : found.methods) add(entry);
}
