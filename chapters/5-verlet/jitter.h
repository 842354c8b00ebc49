// SPDX-License-Identifier: MIT-0
/// @file
/// Position Verlet with frames for steps: as it is, and with two corrections.
#pragma once
#include <algorithm>

#include "frames/recorded.h"
#include "integrate/stormer_verlet.h"
#include "scenes/state.h"

/// No correction: the new frame's length in the formula for equal steps.
inline constexpr auto plain = [](auto& x, auto& x_previous, double t, double h, double,
                                 const auto& scene) {
  integrate::stormer_verlet(x, x_previous, t, h, scene);
};

/// The distance corrected, the push not, as Dummer has it and matter.js.
inline constexpr auto distance_corrected = [](auto& x, auto& x_previous, double t, double h,
                                              double h_previous, const auto& scene) {
  using V = std::decay_t<decltype(x)>;
  const V v = integrate::stormer_verlet_velocity(x, x_previous, h_previous);
  // [distance-corrected]
  const V x_next = x + (h / h_previous) * (x - x_previous) + (h * h) * scene(x, v, t);
  // [distance-corrected]
  x_previous = x;
  x = x_next;
};

/// Both corrected.
inline constexpr auto corrected = [](auto& x, auto& x_previous, double t, double h,
                                     double h_previous, const auto& scene) {
  integrate::stormer_verlet_uneven(x, x_previous, t, h, h_previous, scene);
};

/// Steps of changing length, until some time has passed; `observe(t, x)` after each.
/// @param step  one of the three above
/// @param scene  has `start()`
/// @param duration  [s]
/// @param next  gives the length of the next step [s]
template <class Step, class Scene, class Next, class Observe>
void uneven_run(Step step, const Scene& scene, double duration, Next next, Observe observe) {
  auto [x, v] = scene.start();
  double t = 0, h = next(), h_previous = h;
  auto x_previous = integrate::stormer_verlet_start(x, v, t, h, scene);
  observe(t, x);
  for (; t < duration; h = next()) {
    step(x, x_previous, t, h, h_previous, scene);
    t += h;
    h_previous = h;
    observe(t, x);
  }
}

/// How high a jump goes whose steps are recorded frames [m].
template <class Step, class Scene>
double top(Step step, const Scene& scene, std::size_t first_frame) {
  double highest = 0;
  frames::Playback frames{.at = first_frame};
  uneven_run(
      step, scene, 1.0, [&] { return frames.next(); },
      [&](double, const auto& x) { highest = std::max(highest, x.y()); });
  return highest;
}
