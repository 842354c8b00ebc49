// SPDX-License-Identifier: MIT-0
/// @file
/// Speed against accuracy: what each method gets out of 30, 60, 120 and 240 steps a second.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>

#include "level.h"
#include "measure/energy.h"
#include "measure/record.h"
#include "measure/times.h"

inline constexpr int rates[] = {30, 60, 120, 240};  ///< steps a second
inline constexpr double watched = 60;               ///< how long energy is watched [s]

/// The largest relative change of the energy in a minute.
template <class Scene>
double energy_error(const measure::Method& method, const Scene& scene, double h) {
  const auto energy = [&](const auto& x, const auto& v) { return scene.energy(x, v); };
  return measure::drift(method, scene, h, std::lround(watched / h), energy).largest;
}

/// One row for each method and rate: what it costs in a second of play, and what it is worth.
template <class Scene>
void work(measure::Record& record, const std::string& name, const Scene& scene, double seconds) {
  auto& table = record.table("work-" + name, {{"method"},
                                              {"steps per second", "", measure::whole},
                                              {"evaluations per second", "", measure::whole},
                                              {"largest error", "m"}});
  for (const measure::Method* method : entrants) {
    for (const int rate : rates) {
      const double h = 1.0 / rate;
      table.add({method->name, double(rate), double(rate * price(*method, scene, h)),
                 off(*method, scene, h, seconds)});
    }
  }
}

/// The same for the energy of the shuttle.
inline void work_energy(measure::Record& record) {
  auto& table = record.table("work-energy", {{"method"},
                                             {"steps per second", "", measure::whole},
                                             {"evaluations per second", "", measure::whole},
                                             {"energy error"}});
  for (const measure::Method* method : entrants) {
    for (const int rate : rates) {
      const double h = 1.0 / rate;
      table.add({method->name, double(rate), double(rate * price(*method, shuttle, h)),
                 energy_error(*method, shuttle, h)});
    }
  }
}

inline constexpr int shuttles_at_once = 512;  ///< for which a step of one was timed

/// What the time of a step of one of them is called.
inline std::string timed_of_many(const measure::Method& method) {
  return std::to_string(shuttles_at_once) + " shuttles/" + std::string(method.name);
}

/// The recorded time of a step of one of them [ns].
inline double time_of_many(const measure::Method& method) {
  return measure::recorded_times().at(timed_of_many(method)).median;
}

/// What a step is charged, and the time that it takes: of one shuttle alone, and of one of many.
inline void step_times(measure::Record& record) {
  auto& table = record.table(
      "step-times",
      {{"method"}, {"evaluations", "", measure::whole}, {"alone", "ns"}, {"one of 512", "ns"}});
  for (const measure::Method* method : entrants) {
    const std::string name(method->name);
    table.add({name, double(price(*method, shuttle, frame)), "time:shuttle/" + name,
               "time:" + timed_of_many(*method)});
  }
}

/// The errors of the shuttle beside the recorded times of a step of one of 512. A new method has no
/// time until somebody records all of them anew.
inline void work_time(measure::Record& record) {
  record.number("shuttles-at-once", shuttles_at_once, measure::whole);
  auto& table = record.table("work-time", {{"method"},
                                           {"steps per second", "", measure::whole},
                                           {"time per second of play", "µs"},
                                           {"largest error", "m"}});
  for (const measure::Method* method : entrants) {
    if (!measure::recorded_times().of.contains(timed_of_many(*method))) continue;
    for (const int rate : rates) {
      table.add({method->name, double(rate), 1e-3 * rate * time_of_many(*method),
                 off(*method, shuttle, 1.0 / rate, 8)});
    }
  }
}

/// When RK4's energy error at 60 Hz passes that of velocity Verlet at 240 Hz, which costs as much
/// [s].
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

/// How many turns the shuttle is ahead after a day, by its farthest points [turns].
/// @param started  how long after its nearest point it sets out [s]
inline double ahead_after_a_day(const measure::Method& method, double h, double started = 0) {
  constexpr double day = 86'400;
  double first = 0, last = 0;
  long turns = -1;
  auto kept = measure::start(method, shuttle.exact(started), h, shuttle);
  for (long n = 0; n < std::lround(day / h); ++n) {
    const double outwards = kept[0].dot(kept[1]);
    measure::advance(method, kept, double(n) * h, h, shuttle);
    const double afterwards = kept[0].dot(kept[1]);
    if (outwards <= 0 || afterwards > 0) continue;
    last = (double(n) + outwards / (outwards - afterwards)) * h;
    if (++turns == 0) first = last;
  }
  return day * double(turns) / (last - first) - day / shuttle.period();
}

inline void all_work(measure::Record& record) {
  work(record, "suspension", suspension, 1);
  work(record, "leaf", leaf, 2);
  work(record, "lamp", lamp, 10);
  work(record, "shuttle", shuttle, 8);
  work_energy(record);
  record.number("energy-nearer",
                energy_error(method::velocity_verlet, shuttle, frame / 4) /
                    energy_error(method::rk4, shuttle, frame),
                2);
  record.number("energy-passes", energy_passes() / 60, 3, "min");
  record.number("day-verlet", -ahead_after_a_day(method::velocity_verlet, frame / 4), 2);
  record.number("day-verlet-later", ahead_after_a_day(method::velocity_verlet, frame / 4, 1), 1);
  record.number("day-rk4", ahead_after_a_day(method::rk4, frame), 2);
  record.number("shuttle-240-symplectic",
                100 * off(method::symplectic_euler, shuttle, frame / 4, 8), 2, "cm");
  record.number("shuttle-240-verlet", 100 * off(method::velocity_verlet, shuttle, frame / 4, 8), 2,
                "cm");
  record.number("shuttle-240-rk4", 1e6 * off(method::rk4, shuttle, frame, 8), 2, "µm");
  record.number(
      "rk4-nearer",
      off(method::symplectic_euler, shuttle, frame / 4, 8) / off(method::rk4, shuttle, frame, 8),
      2);
  step_times(record);
  work_time(record);
}
