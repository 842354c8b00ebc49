// SPDX-License-Identifier: MIT-0
/// @file
/// Speed against accuracy: what each method gets out of 30 steps a second, or 960.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>

#include "choose/entrants.h"
#include "level.h"
#include "measure/energy.h"
#include "measure/record.h"
#include "measure/times.h"
#include "position_error.h"

inline constexpr int rates[] = {30, 60, 120, 240, 480, 960};  ///< steps a second
inline constexpr double watched = 60;                         ///< how long energy is watched [s]

/// The largest relative change of the energy, in a minute unless told otherwise.
template <class Scene>
double energy_error(const measure::Method& method, const Scene& scene, double h,
                    double seconds = watched) {
  const auto energy = [&](const auto& x, const auto& v) { return scene.energy(x, v); };
  return measure::drift(method, scene, h, std::lround(seconds / h), energy).largest;
}

/// The cost of a step of a method in one thing of the level.
struct MethodCost {
  const measure::Method* method;
  double evaluations;  ///< of a step
  double nanoseconds;  ///< of a step, of one of many bodies in a loop; NaN until it is recorded
};

/// The costs of methods on a scene.
template <class Scene>
std::vector<MethodCost> costs_of(const std::vector<const measure::Method*>& methods,
                                 const std::string& thing, const Scene& scene) {
  std::vector<MethodCost> all;
  for (const measure::Method* method : methods) {
    all.push_back(
        {method, double(price(*method, scene, frame)), step_time(thing, in_a_loop, *method)});
  }
  return all;
}

/// The largest error of a thing at a rate that need not divide a second [m]; a nanometre at least.
template <class Scene>
double max_position_error_at_rate(double rate, const measure::Method& method, const Scene& scene,
                                  double seconds) {
  const double steps = std::floor(rate * seconds);
  return std::max(max_position_error(method, scene, seconds / steps, seconds), 1e-9);
}

/// Returns whether a method has the places of velocity Verlet, which stands for it on the charts.
inline bool is_equivalent_to_velocity_verlet(const measure::Method& one) {
  return &one == &method::stormer_verlet || &one == &method::leapfrog;
}

/// The best that a price buys.
struct BestForBudget {
  const measure::Method* method = nullptr;  ///< null if it buys nothing
  double error = INFINITY;                  ///< [m]
};

/// A method that is in use is left only for one that is more than twice as near.
template <class Scene>
BestForBudget best_for(double price, double MethodCost::* cost,
                       const std::vector<MethodCost>& costs, const Scene& scene, double seconds,
                       const measure::Method* in_use) {
  BestForBudget best, used;
  for (const MethodCost& candidate : costs) {
    if (is_equivalent_to_velocity_verlet(*candidate.method)) continue;
    const double rate = std::min(price / (candidate.*cost), double(rates[std::size(rates) - 1]));
    if (!(rate >= 0.999 * rates[0])) continue;
    const BestForBudget bought{candidate.method,
                               max_position_error_at_rate(rate, *candidate.method, scene, seconds)};
    if (bought.error < best.error) best = bought;
    if (candidate.method == in_use) used = bought;
  }
  return used.method && used.error <= 2 * best.error ? used : best;
}

/// The name of a method on a chart.
inline std::string chart_name(const measure::Method& method) {
  if (&method == &method::backward_euler_spring) return "soft constraint";
  const std::string name(method.name), swapped = "symplectic Euler, ";
  return name.starts_with(swapped) ? name.substr(swapped.size()) : name;
}

/// Prices from one to another, twelve in each power of ten.
inline std::vector<double> prices(double from, double to) {
  std::vector<double> all;
  for (int n = 0; all.empty() || all.back() < to; ++n) all.push_back(from * std::pow(10, n / 12.0));
  return all;
}

/// The prices of a chart, in its units.
struct Priced {
  double MethodCost::* cost;
  double unit = 1;               ///< of the chart's prices, for one of the cost's
  std::vector<double> prices{};  ///< the lowest first
};

/// The best method for each price, as far as anything comes within ten metres and nothing is exact.
template <class Scene>
std::vector<std::pair<double, BestForBudget>> answers(const Priced& priced,
                                                      const std::vector<MethodCost>& costs,
                                                      const Scene& scene, double seconds) {
  std::vector<std::pair<double, BestForBudget>> all;
  const measure::Method* last = nullptr;
  for (const double price : priced.prices) {
    const BestForBudget best =
        best_for(price / priced.unit, priced.cost, costs, scene, seconds, last);
    if (!(best.error < 10)) continue;
    all.push_back({price, best});
    last = best.method;
    if (best.error <= 1e-9) break;
  }
  return all;
}

/// Adds one row for each price, with the method to take for it.
/// @param panel  of the figure
inline void add_answers(measure::Table& table, const std::string& panel,
                        const std::vector<std::pair<double, BestForBudget>>& all) {
  double changes = 0;
  const auto changes_at = [&](std::size_t n) {
    return n == 0 || all[n].second.method != all[n - 1].second.method;
  };
  for (std::size_t n = 0; n < all.size(); ++n) changes += changes_at(n);
  for (std::size_t n = 0; n < all.size(); ++n) {
    const auto& [price, best] = all[n];
    table.add(
        {panel, chart_name(*best.method), price, best.error, changes_at(n) ? changes-- : 0.0});
  }
}

/// The prices of the figure's left panels.
inline Priced by_evaluations() {
  return {&MethodCost::evaluations, 1, prices(rates[0], 6000)};
}

/// The prices of its right panel for a thing [µs for a second of play].
inline Priced by_time(const std::string& thing) {
  const double verlet = step_time(thing, in_a_loop, method::velocity_verlet);
  return {&MethodCost::nanoseconds, 1e-3, prices(1e-3 * rates[0] * verlet, 100)};
}

/// Error against price for each thing of the level, and the answer: at this price, this method.
inline void work_precision(measure::Record& record) {
  record.number("at-once", double(in_a_loop), measure::whole);
  record.number("beyond-the-cache", double(beyond_the_cache), measure::whole);
  auto& work = record.table("work", {{"thing"},
                                     {"method"},
                                     {"steps per second", "", measure::whole},
                                     {"evaluations", "", measure::whole},
                                     {"microseconds", "µs"},
                                     {"error", "m"}});
  auto& bought = record.table("work-answers",
                              {{"panel"}, {"method"}, {"price"}, {"error", "m"}, {"changes left"}});
  auto& exact = record.table("work-exact", {{"thing"},
                                            {"function"},
                                            {"steps per second", "", measure::whole},
                                            {"evaluations", "", measure::whole},
                                            {"microseconds", "µs"}});
  for_each_thing([&](const std::string& thing, const auto& scene, double seconds) {
    for (const MethodCost& candidate : costs_of(exact_steps_of(scene), thing, scene)) {
      for (const int rate : rates) {
        exact.add({thing, candidate.method->function, double(rate), rate * candidate.evaluations,
                   1e-3 * rate * candidate.nanoseconds});
      }
    }
    const std::vector<MethodCost> costs = costs_of(entrants_on(scene), thing, scene);
    for (const MethodCost& candidate : costs) {
      for (const int rate : rates) {
        work.add({thing, chart_name(*candidate.method), double(rate), rate * candidate.evaluations,
                  1e-3 * rate * candidate.nanoseconds,
                  max_position_error_at_rate(rate, *candidate.method, scene, seconds)});
      }
    }
    add_answers(bought, thing + " by evaluations",
                answers(by_evaluations(), costs, scene, seconds));
    add_answers(bought, thing + " by microseconds", answers(by_time(thing), costs, scene, seconds));
  });
}

/// The share of a frame that a step of a thousand takes [%].
inline double share_of_a_frame(const char* thing, const measure::Method& method) {
  return 100 * 1e-9 * 1000 * step_time(thing, in_a_loop, method) / frame;
}

/// Single times that the prose tells.
inline void quoted_times(measure::Record& record) {
  record.number("frame-shuttles", share_of_a_frame("shuttle", method::dopri5), 1, "%");
  record.number("frame-suspensions", share_of_a_frame("suspension", method::rk4), 1, "%");
  record.number("exact-times",
                step_time("suspension", in_a_loop, method::spring_exact) /
                    step_time("suspension", in_a_loop, method::velocity_verlet),
                2);
}

/// Records the error of the energy of the shuttle against the price.
inline void work_energy(measure::Record& record) {
  auto& table = record.table("work-energy", {{"method"},
                                             {"steps per second", "", measure::whole},
                                             {"evaluations per second", "", measure::whole},
                                             {"energy error"}});
  for (const measure::Method* method : entrants) {
    for (const int rate : {30, 60, 120, 240}) {
      const double h = 1.0 / rate;
      table.add({method->name, double(rate), double(rate * price(*method, shuttle, h)),
                 energy_error(*method, shuttle, h)});
    }
  }
}

/// Records the price of a step, and its time: of one shuttle alone, of one of many, and of
/// one of more than the caches hold.
inline void step_times(measure::Record& record) {
  auto& table = record.table("step-times", {{"method"},
                                            {"evaluations", "", measure::whole},
                                            {"alone", "ns"},
                                            {"one of 512", "ns"},
                                            {"one of 100 000", "ns"}});
  const auto time = [](std::size_t bodies, const measure::Method& method) {
    return "time:" + step_name("shuttle", bodies, method.function);
  };
  for (const measure::Method* method : entrants) {
    table.add({method->name, double(price(*method, shuttle, frame)), time(one_body, *method),
               time(in_a_loop, *method), time(beyond_the_cache, *method)});
  }
}

/// The recorded times of a step in a loop, for the figure in which readers take their own.
inline void recorded_steps(measure::Record& record) {
  auto& table = record.table(
      "recorded-steps",
      {{"thing"}, {"method"}, {"header"}, {"exact", "", measure::whole}, {"nanoseconds", "ns"}});
  record.number("most-tried", double(tried_in_a_frame.back()), measure::whole);
  for_each_thing([&](const std::string& thing, const auto& scene, double) {
    const auto add = [&](const measure::Method* method, double exact) {
      table.add(
          {thing, method->function, method->header, exact, step_time(thing, in_a_loop, *method)});
    };
    for (const measure::Method* method : entrants_on(scene)) add(method, 0);
    for (const measure::Method* method : exact_steps_of(scene)) add(method, 1);
  });
}

/// The time of a step of the suspension in several layouts, for the methods that solve for nothing,
/// the quickest of them first.
inline void layouts(measure::Record& record) {
  auto& table = record.table("layouts", {{"method"},
                                         {"row", "", measure::whole},
                                         {"layout"},
                                         {"bodies", "", measure::whole},
                                         {"time"},
                                         {"ns"}});
  std::vector<const measure::Method*> methods;
  for (const measure::Method* method : entrants) {
    // Those that solve for their step are not timed in packs.
    if (!std::isnan(step_time("packs of float", in_a_loop, *method))) methods.push_back(method);
  }
  std::sort(methods.begin(), methods.end(), [](const auto* one, const auto* other) {
    return step_time("packs of float", in_a_loop, *one) <
           step_time("packs of float", in_a_loop, *other);
  });
  record.number("rows", double(methods.size()), measure::whole);
  for (std::size_t row = 0; row < methods.size(); ++row) {
    const auto add = [&](const char* layout, std::size_t bodies) {
      table.add({methods[row]->name, double(row + 1), layout, double(bodies),
                 step_name(layout, bodies, methods[row]->function),
                 step_time(layout, bodies, *methods[row])});
    };
    add("structs of double", one_body);
    add("structs of double", in_a_loop);
    add("structs of double", beyond_the_cache);
    add("packs of float", in_a_loop);
    add("packs of float", beyond_the_cache);
  }
}

/// The time at which RK4's energy error at 60 Hz passes that of velocity Verlet at 240 Hz, which
/// costs as much [s].
inline double energy_passes() {
  const double sways = energy_error(method::velocity_verlet, shuttle, frame / 4);
  auto s = shuttle.start();
  const double first = shuttle.energy(s.x, s.v);
  double passed = INFINITY;
  measure::run(method::rk4, shuttle, s, frame, 3 * 3600 * 60, [&](double t, const auto& now) {
    const double error = std::abs(shuttle.energy(now.x, now.v) / first - 1);
    if (error > sways) passed = std::min(passed, t);
  });
  return passed;
}

inline constexpr double day = 86'400;  ///< [s]

/// The turns by which the shuttle is ahead after a day, by its farthest points.
/// @param started  how long after its nearest point it sets out [s]
inline double ahead_after_a_day(const measure::Method& method, double h, double started = 0) {
  double first = 0, last = 0;
  long turns = -1;
  auto memory = measure::start(method, shuttle.exact(started), h, shuttle);
  for (long n = 0; n < std::lround(day / h); ++n) {
    const double outwards = memory[0].dot(memory[1]);
    measure::advance(method, memory, double(n) * h, h, shuttle);
    const double afterwards = memory[0].dot(memory[1]);
    if (outwards <= 0 || afterwards > 0) continue;
    last = (double(n) + outwards / (outwards - afterwards)) * h;
    if (++turns == 0) first = last;
  }
  return day * double(turns) / (last - first) - day / shuttle.period();
}

inline void all_work(measure::Record& record) {
  work_precision(record);
  work_energy(record);
  record.number("energy-nearer",
                energy_error(method::velocity_verlet, shuttle, frame / 4) /
                    energy_error(method::rk4, shuttle, frame),
                2);
  record.number("energy-passes", energy_passes() / 60, 3, "min");
  record.number("day-verlet", -ahead_after_a_day(method::velocity_verlet, frame / 4), 2);
  record.number("day-verlet-later", ahead_after_a_day(method::velocity_verlet, frame / 4, 1), 1);
  record.number("day-yoshida-energy",
                100 * energy_error(method::yoshida4, shuttle, 3 * frame / 4, day), 2, "%");
  record.number("day-verlet-energy",
                100 * energy_error(method::velocity_verlet, shuttle, frame / 4, day), 2, "%");
  record.number("day-rk4", ahead_after_a_day(method::rk4, frame), 2);
  record.number("shuttle-240-symplectic",
                100 * max_position_error(method::symplectic_euler, shuttle, frame / 4, 8), 2, "cm");
  record.number("shuttle-240-verlet",
                100 * max_position_error(method::velocity_verlet, shuttle, frame / 4, 8), 2, "cm");
  record.number("shuttle-240-rk4", 1e6 * max_position_error(method::rk4, shuttle, frame, 8), 2,
                "µm");
  record.number("rk4-nearer",
                max_position_error(method::symplectic_euler, shuttle, frame / 4, 8) /
                    max_position_error(method::rk4, shuttle, frame, 8),
                2);
  step_times(record);
  quoted_times(record);
  recorded_steps(record);
  layouts(record);
}
