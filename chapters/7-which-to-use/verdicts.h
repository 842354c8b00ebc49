// SPDX-License-Identifier: MIT-0
/// @file
/// The talks' verdicts, methods by kinds of force, and each cell as it was measured.
#pragma once
#include <string>

#include "measure/energy.h"
#include "measure/longest_stable_step.h"
#include "measure/record.h"
#include "measure/stability.h"
#include "position_error.h"

// [kinds]
// The drone is in chapters/cast.h.
inline constexpr scenes::LinearDrag<> skid{.c = 2, .g = 0, .v0 = 10};
inline constexpr scenes::Toss toss(10);

inline constexpr double minute = 60;  ///< the drone is watched for so long [s]
inline constexpr double moment = 2;   ///< the skid and the toss [s]
// [kinds]

// [words]
/// The talks' words, for an error in per cent of the size of the motion.
inline std::string verdict_word(double percent) {
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

inline Verdict verdict(const measure::Method& method) {
  const double way = skid.v0 / skid.c, height = toss.v0 * toss.v0 / (2 * toss.g);
  return {100 * max_position_error(method, drone, frame, minute) / drone.radius,
          100 * max_position_error(method, skid, frame, moment) / way,
          100 * max_position_error(method, toss, frame, moment) / height};
}

/// The drift of the drone's energy in a minute, as shares of it.
inline measure::Drift energy_of_drone(const measure::Method& method) {
  const auto energy = [](const auto& x, const auto& v) { return drone.energy(x, v); };
  return measure::drift(method, drone, frame, 3600, energy);
}

inline void verdicts(measure::Record& record) {
  auto& table = record.table("verdicts", {{"method"},
                                          {"force by"},
                                          {"a talk says"},
                                          {"off at 60 Hz", "%", 2},
                                          {"measured"},
                                          {"energy off in a minute", "%", 2},
                                          {"longest step"}});
  const auto add = [&](const measure::Method& method, const char* position, const char* velocity,
                       const char* constant) {
    const std::string name(method.name);
    const Verdict found = verdict(method);
    const double spring =
        measure::in_three_digits(measure::longest_stable_step(method, scenes::Spring<>{}));
    const double drag = measure::in_three_digits(
        measure::longest_stable_step(method, scenes::LinearDrag<>{.c = 1, .g = 0}));
    table.add({name, "position", position, or_rounding(found.position),
               verdict_word(found.position), 100 * energy_of_drone(method).largest, spring});
    table.add({name, "velocity", velocity, or_rounding(found.velocity),
               verdict_word(found.velocity), NAN, drag});
    table.add({name, "constant", constant, or_rounding(found.constant),
               verdict_word(found.constant), NAN, INFINITY});
  };
  add(method::euler, "lousy", "okay", "bad");
  add(method::rk4, "okay", "okay", "great");
  add(method::backward_euler, "okay", "great", "bad");
  add(method::velocity_verlet, "better", "okay", "okay");
  add(method::symplectic_euler, "good", "okay", "bad");
  record.number("drone-backward-energy", 100 + 100 * energy_of_drone(method::backward_euler).last,
                2, "%");
  record.number("drone-symplectic", verdict(method::symplectic_euler).position, 1, "%");
}
