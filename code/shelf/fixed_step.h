// SPDX-License-Identifier: MIT-0
/// @file
/// Steps of one length out of frames of any length.
///
/// @code
/// shelf::FixedStep<> clock{1 / 64.0};
/// double before = 0, height = 0, speed = 5;
/// const double frames[] = {0.010, 0.030, 0.005, 0.040};
/// for (const double frame : frames) {
///   clock.frame(frame, [&](double) {
///     before = height;
///     speed = speed - 9.81 * clock.h;
///     height = height + speed * clock.h;
///   });
/// }
/// const double shown = before + clock.blend() * (height - before);
/// // Now clock.steps is 5.
/// // Now shown is 0.31766.
/// @endcode
///
/// Keep it in double, beside vectors of floats as well: `FixedStep<>`, and `float(clock.h)` in the
/// step. `FixedStep<float>`, with `1 / 60.0f`, is for what never asks for the time: in float, after
/// an hour, two steps of 16.67 ms in a row begin 16.60 or 16.85 ms apart. Ten seconds of frames may
/// make 599 steps, with nearly a whole one saved, since a sixtieth is no binary number. To draw
/// between two steps, keep a copy of what was before the last, as here; blend.h has other ways.
///
/// For slow motion make the frames shorter, `clock.frame(0.25 * frame, step)`, and for a pause
/// bring none: the steps are the same, and so is the jump. Leave `h` as it is. A step begins at
/// steps * h, so another h changes the time that has passed: halved after ten seconds, it goes back
/// to five.
///
/// Promises:
/// - the same steps, to the last bit, from even frames and from 600 recorded ones
/// - steps and saved time add up to the time that the frames took, to 1e-12 of it
/// - a frame longer than the longest takes as many steps as the longest
/// - a frame whose length is negative or not a number takes no step and stops no clock
/// - after a day two steps in a row begin 1/60 s apart, to 1e-9 of it; in float 15.6 or 23.4 ms
/// - frames a quarter as long, for slow motion, make the same steps, to the last bit
#pragma once

/// Things that a game needs beside a method, one per header, to copy as well.
namespace shelf {

// [fixed]
/// Saves up frame time and spends it in equal steps.
///
/// Under -ffast-math it makes no promise about a frame whose length is not a number.
///
/// @tparam Real  type of a duration [s]
/// @see G. Fiedler, Fix Your Timestep! (2004)
template <class Real = double>
struct FixedStep {
  Real h = Real(1) / Real(60);       ///< step size [s], above zero; the time is steps * h
  Real longest_frame = Real(1) / 4;  ///< time beyond this in one frame is dropped [s]; finite
  Real saved = 0;                    ///< time not yet spent, always under one step [s]
  long long steps = 0;               ///< steps taken so far

  /// Spends a frame. A negative length, from a clock that was set back, counts as none, and so does
  /// one that is not a number.
  /// @param length  how long the frame took [s]
  /// @param step  called as `step(t)` for each step due, with the time at its start [s]
  template <class Step>
  constexpr void frame(Real length, Step&& step) {
    // [spend]
    if (length > Real(0)) saved += length < longest_frame ? length : longest_frame;
    for (; saved >= h; saved -= h) step(Real(steps++) * h);
    // [spend]
  }

  /// How far the screen is between the last two states: 0 at the older one, 1 at the newer.
  constexpr Real blend() const { return saved / h; }
};
// [fixed]

}  // namespace shelf
