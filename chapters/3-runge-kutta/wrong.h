// SPDX-License-Identifier: MIT-0
/// @file
/// Methods with a fault in one place, and what the fault is.
#pragma once
#include <type_traits>

/// Methods that are wrong on purpose.
namespace wrong {

/// Wrong on purpose: finds the velocity in the middle of the step, and moves with the old one.
inline constexpr auto old_velocity = [](auto& x, auto& v, auto t, auto h, auto&& acceleration) {
  using Vec = std::decay_t<decltype(x)>;
  // [move]
  const Vec x_middle = x + (h / 2) * v;
  const Vec v_middle = v + (h / 2) * acceleration(x, v, t);
  x = x + h * v;
  v = v + h * acceleration(x_middle, v_middle, t + h / 2);
  // [move]
};

/// What a method of four slopes is made of. As it stands here it is RK4.
struct Stages {
  int position_from[4] = {0, 0, 1, 2};  ///< whose velocity leads to the place of a stage
  int velocity_from[4] = {0, 0, 1, 2};  ///< whose slope leads to its velocity
  double reach[4] = {0, 0.5, 0.5, 1};   ///< how far, in steps
  double clock[4] = {0, 0.5, 0.5, 1};   ///< at what time, in steps
  double weight[4] = {1. / 6, 1. / 3, 1. / 3, 1. / 6};  ///< how much the slope counts
};

/// One step of the method that `stages` describes.
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]
/// @param acceleration  callable `(x, v, t) -> Vec`
template <class Vec, class Time, class Real, class Acceleration>
void step_by(const Stages& stages, Vec& x, Vec& v, Time t, Real h,
             const Acceleration& acceleration) {
  Vec velocity[4] = {v, v, v, v};
  Vec slope[4] = {v, v, v, v};
  for (int i = 0; i < 4; ++i) {
    const Real part = h * Real(stages.reach[i]);
    Vec place = x;
    if (i > 0) {
      place = x + part * velocity[stages.position_from[i]];
      velocity[i] = v + part * slope[stages.velocity_from[i]];
    }
    slope[i] = acceleration(place, velocity[i], t + h * Real(stages.clock[i]));
  }
  for (int i = 0; i < 4; ++i) {
    x = x + (h * Real(stages.weight[i])) * velocity[i];
    v = v + (h * Real(stages.weight[i])) * slope[i];
  }
}

/// The method that `stages` describes, as an object that can be handed to run().
inline auto method_of(const Stages& stages) {
  return [stages](auto& x, auto& v, auto t, auto h, const auto& acceleration) {
    step_by(stages, x, v, t, h, acceleration);
  };
}

/// A method with a fault, and what the fault is.
struct Bug {
  const char* what;  ///< in the words of the chapter's table
  Stages stages;     ///< with the fault
};

/// Five ways to get RK4 wrong in one place.
inline const Bug fourth_looks_too_soon{
    "fourth stage along the second slope",
    {.position_from = {0, 0, 1, 1}, .velocity_from = {0, 0, 1, 1}}};
inline const Bug third_is_second{"third stage repeats the second",
                                 {.position_from = {0, 0, 0, 2}, .velocity_from = {0, 0, 0, 2}}};
inline const Bug stale_velocities{"stages with the old velocity", {.position_from = {0, 0, 0, 0}}};
inline const Bug stopped_clock{"clock stands still", {.clock = {0, 0, 0, 0}}};
inline const Bug equal_weights{"all slopes count the same", {.weight = {0.25, 0.25, 0.25, 0.25}}};

}  // namespace wrong
