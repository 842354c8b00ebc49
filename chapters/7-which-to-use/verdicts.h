// SPDX-License-Identifier: MIT-0
/// @file
/// The talks' verdicts, methods by kinds of force, and what each cell comes to when it is measured.
#pragma once
#include <string>

#include "level.h"
#include "measure/energy.h"
#include "measure/record.h"
#include "measure/stability.h"
#include "scenes/circle.h"

// [kinds]
inline constexpr scenes::Circle<> drone{.omega = eight_seconds, .radius = 10};
inline constexpr scenes::LinearDrag<> skid{.c = 2, .g = 0, .v0 = 10};
inline constexpr Ball toss{{.c = 0, .v0 = 10}};

inline constexpr double minute = 60;  ///< the drone is watched for so long [s]
inline constexpr double moment = 2;   ///< the skid and the toss [s]
// [kinds]

// [words]
/// The talks' words, for an error in per cent of the size of the motion.
inline std::string word(double percent) {
  if (percent < 0.01) return "great";
  if (percent < 0.1) return "good";
  if (percent < 1) return "okay";
  return percent < 10 ? "bad" : "lousy";
}
// [words]

/// Errors at 60 Hz, in per cent of the size of the motion.
struct Verdict {
  double position, velocity, constant;
};

template <class Step>
Verdict verdict(const Step& step) {
  const double way = skid.v0 / skid.c, height = toss.v0 * toss.v0 / (2 * toss.g);
  return {100 * off(step, drone, frame, minute) / drone.radius,
          100 * off(step, skid, frame, moment) / way,
          100 * off(step, toss, frame, moment) / height};
}

/// What becomes of the drone's energy in a minute, as shares of it.
template <class Step>
measure::Drift energy_of_drone(const Step& step) {
  const auto energy = [](const auto& x, const auto& v) { return drone.energy(x, v); };
  return measure::drift(step, drone, frame, 3600, energy);
}

/// The largest stable step, times omega or c; infinite from 1000 on, zero if there is none.
template <class Step, class Scene>
double longest_step(const Step& step, const Scene& scene) {
  const auto stable = [&](double h) {
    return measure::spectral_radius(step, scene, h) <= 1 + 1e-12;
  };
  if (!stable(0.05)) return 0;
  if (stable(1000)) return INFINITY;
  return measure::stability_limit(step, scene, 0.05, 1000);
}

inline void verdicts(measure::Record& record) {
  auto& table = record.table("verdicts", {{"method"},
                                          {"force by"},
                                          {"a talk says"},
                                          {"off at 60 Hz", "%", 2},
                                          {"measured"},
                                          {"energy off in a minute", "%", 2},
                                          {"longest step"}});
  const auto add = [&](const std::string& name, auto step, const char* position,
                       const char* velocity, const char* constant) {
    const Verdict found = verdict(step);
    const double spring = longest_step(step, scenes::Spring<>{});
    const double drag = longest_step(step, scenes::LinearDrag<>{.c = 1, .g = 0});
    table.add({name, "position", position, found.position, word(found.position),
               100 * energy_of_drone(step).largest, spring});
    table.add({name, "velocity", velocity, found.velocity, word(found.velocity), NAN, drag});
    table.add({name, "constant", constant, found.constant, word(found.constant), NAN, INFINITY});
  };
  add("Euler", measure::euler, "lousy", "okay", "bad");
  add("RK4", measure::rk4, "okay", "okay", "great");
  add("backward Euler", measure::backward_euler, "okay", "great", "bad");
  add("velocity Verlet", measure::velocity_verlet, "better", "okay", "okay");
  add("symplectic Euler", measure::symplectic_euler, "good", "okay", "bad");
  record.number("drone-backward-energy", 100 + 100 * energy_of_drone(measure::backward_euler).last,
                2, "%");
  record.number("drone-symplectic", verdict(measure::symplectic_euler).position, 1, "%");
}
