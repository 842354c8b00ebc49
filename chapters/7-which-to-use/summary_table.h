// SPDX-License-Identifier: MIT-0
/// @file
/// The summary of the chapter: a method for each kind of thing, and its limits at sixty steps a
/// second.
#pragma once
#include <numbers>
#include <string>
#include <string_view>

#include "choose/contest.h"
#include "choose/entrants.h"
#include "measure/longest_stable_step.h"
#include "measure/record.h"
#include "verdicts.h"

/// One swing a second.
inline constexpr scenes::Spring<> clock_spring = swinging(1);

/// The most that the energy of a swing a second is off in a minute at 60 Hz [%].
inline double energy_drift_in_a_minute(const measure::Method& method) {
  const auto energy = [](double x, double v) { return clock_spring.energy(x, v); };
  return 100 * measure::drift(method, clock_spring, frame, 3600, energy).largest;
}

/// The most swings a second of a spring that a method holds at 60 Hz; of a damped one, those that
/// it would make without its damper.
inline double swings_held(const measure::Method& method, double zeta = 0) {
  return measure::longest_stable_step(method, scenes::Spring<>{.zeta = zeta}) / frame /
         (2 * std::numbers::pi);
}

inline void summary_table(measure::Record& record) {
  auto& table = record.table("wall", {{"what moves"},
                                      {"take"},
                                      {"evaluations a step", "", measure::whole},
                                      {"stable to", "swings/s", 2},
                                      {"at ζ = 1", "swings/s", 2},
                                      {"energy off in a minute", "%", 2},
                                      {"header"}});
  const auto add = [&](const char* moves, const char* take, const measure::Method& method,
                       std::string_view header) {
    table.add({moves, take, double(price(method, suspension, frame)), swings_held(method),
               swings_held(method, 1), or_rounding(energy_drift_in_a_minute(method)),
               std::string(header)});
  };
  const auto add_its_own = [&](const char* moves, const char* take, const measure::Method& method) {
    add(moves, take, method, method.header);
  };
  table.add({"a constant force: jumps, shells, sparks", "the exact step",
             double(price(method::constant_acceleration, height_of_jump, frame)), NAN, NAN, NAN,
             method::constant_acceleration.header});
  add_its_own("one spring: cameras, doors, recoil, suspensions", "the exact step",
              method::spring_exact);
  add_its_own("bodies with contacts, joints and springs", "symplectic Euler",
              method::symplectic_euler);
  add_its_own("the same with drag against the air, or a damper to something fixed", "drag divided",
              method::linear_damping_implicit_last);
  // Between two bodies the relative motion is the spring, and the division is the same.
  add("two bodies with a damper between them", "relative velocity divided",
      method::linear_damping_implicit_last, "damper.h");
  // It has no springs to hold: the constraints do that.
  table.add({"ropes and cloth of particles, by constraints", "Störmer–Verlet",
             double(price(method::stormer_verlet, suspension, frame)), NAN, NAN, NAN,
             std::string(method::stormer_verlet.header)});
  add_its_own("orbits and pendulums that never end; falls through air while ch < 1",
              "velocity Verlet", method::velocity_verlet);
  add_its_own("long orbits without drag whose place counts", "Yoshida 4", method::yoshida4);
  add_its_own("a path that must be right: previews, flight", "RK4", method::rk4);
  add_its_own("what is too stiff for the frame", "backward Euler", method::backward_euler);
  add_its_own("answers to compare with, in tools", "Dormand-Prince", method::dopri5);
}
