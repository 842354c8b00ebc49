// SPDX-License-Identifier: MIT-0
/// @file
/// Steps of one length out of frames of any length.
#pragma once
#include <algorithm>

/// What stands between the steps of a scene and the frames of a screen.
namespace frames {

// [fixed]
/// Saves up frame time and spends it in equal steps.
///
/// @tparam Real  type of a duration [s]
/// @see G. Fiedler, Fix Your Timestep! (2004)
template <class Real = double>
struct FixedStep {
  Real h = Real(1) / Real(60);       ///< step size [s]
  Real longest_frame = Real(1) / 4;  ///< time beyond this in one frame is dropped [s]
  Real saved = 0;                    ///< time not yet spent, always under one step [s]
  long steps = 0;                    ///< steps taken so far

  /// Spends a frame. A negative length, from a clock that was set back, counts as none, and so does
  /// one that is not a number.
  /// @param length  how long the frame took [s]
  /// @param step  called as `step(t)` for each step due, with the time at its start [s]
  template <class Step>
  constexpr void frame(Real length, Step&& step) {
    if (length > Real(0)) saved += (std::min)(length, longest_frame);
    for (; saved >= h; saved -= h) step(Real(steps++) * h);
  }

  /// How far the screen is between the last two states: 0 at the older one, 1 at the newer.
  constexpr Real blend() const { return saved / h; }
};
// [fixed]

}  // namespace frames
