// SPDX-License-Identifier: MIT-0
/// @file
/// Steps of one length out of frames of any length.
///
/// @code
/// shelf::FixedStep<> clock{1 / 64.0};
/// double before = 0, height = 0, speed = 5;
/// const auto step = [&](double) {
///   before = height;
///   speed = speed - 9.81 * clock.h;
///   height = height + speed * clock.h;
/// };
/// const double frames[] = {0.010, 0.030, 0.005, 0.040};
/// for (const double frame : frames) clock.frame(frame, step);
/// const double shown = before + clock.blend() * (height - before);
/// // Now clock.steps is 5.
/// // Now shown is 0.31766.
///
/// // Slow motion; a pace of 0 is a pause.
/// const double pace = 0.25;
/// for (const double frame : frames) clock.frame(pace * frame, step);
/// // Now clock.steps is 6.
///
/// // Twice as many steps a second from here on.
/// clock.change_step(1 / 128.0);
/// // Now clock.time() is 0.09375.
///
/// // Put elsewhere, and not seen on its way.
/// before = height = 10;
/// // Now before + clock.blend() * (height - before) is 10.
/// @endcode
///
/// Beside vectors of floats take `FixedStep<float>`: `h` and `blend()` are floats, and the time
/// stays in double. A `FixedStep<float, float>` is for what never asks for the time: after an hour
/// two steps of 16.67 ms in a row begin 16.60 or 16.85 ms apart. Ten seconds of frames may make 599
/// steps, with nearly a whole one saved, since a sixtieth is no binary number. To draw between two
/// steps, keep a copy of what was before the last, as here; blend.h has other ways.
///
/// For slow motion make the frames shorter, not the steps: these are the same, and so is the jump.
/// Change `h` by `change_step` alone, since the time is counted in steps: if h were halved by hand
/// after ten seconds, it would go back to five.
///
/// Promises:
/// - the same steps, to the last bit, from even frames and from 600 recorded ones
/// - steps and saved time add up to the time that the frames took, to 1e-12 of it
/// - a frame longer than the longest takes as many steps as the longest
/// - a frame whose length is negative or not a number takes no step and stops no clock
/// - after a day at 60 Hz two steps in a row begin h apart, to 1e-9 of it, where h is a float, too
/// - where the time is a float, they begin 15.6 or 23.4 ms apart
/// - frames a quarter as long, for slow motion, make the same steps, to the last bit
/// - with another h once a second, steps and time still add up, to 1e-12 of the time
#pragma once

/// Things that a game needs beside a method, one per header, to copy as well.
namespace shelf {

// [fixed]
/// Saves up frame time and spends it in equal steps.
///
/// Under -ffast-math it makes no promise about a frame whose length is not a number.
///
/// @tparam Real  type of the step size [s], that of the numbers in your vectors
/// @tparam Time  type of the time [s]
/// @see G. Fiedler, Fix Your Timestep! (2004)
template <class Real = double, class Time = double>
struct FixedStep {
  Real h = Real(1) / Real(60);       ///< step size [s], above zero; see change_step
  Time longest_frame = Time(1) / 4;  ///< time beyond this in one frame is dropped [s]; finite
  Time saved = 0;                    ///< time not yet spent, under one step until h changes [s]
  long long steps = 0;               ///< steps taken so far
  Time start = 0;                    ///< when step 0 was, had all steps been of this size [s]

  /// Spends a frame. A negative length, from a clock that was set back, counts as none, and so does
  /// one that is not a number.
  /// @param length  how long the frame took [s]
  /// @param step  called as `step(t)` for each step due, with the time at its start [s]
  template <class Step>
  constexpr void frame(Time length, Step&& step) {
    // [spend]
    if (!(length > Time(0))) return;
    saved += length < longest_frame ? length : longest_frame;
    while (saved >= Time(h)) {
      const Time t = time();
      saved -= Time(h);
      ++steps;
      step(t);
    }
    // [spend]
  }

  /// How far the screen is between the last two states: 0 at the older one, 1 at the newer.
  constexpr Real blend() const { return saved < Time(h) ? Real(saved / Time(h)) : Real(1); }

  /// The time that the steps have reached [s]: that of the newest state.
  constexpr Time time() const { return start + Time(steps) * Time(h); }

  /// Goes on in steps of another size; no time is lost, and the steps are counted on. To be called
  /// before a frame, or within a step for those behind it.
  /// @param size  step size from now on [s]; one that is not above zero changes nothing
  constexpr void change_step(Real size) {
    if (!(size > Real(0))) return;
    start += Time(steps) * (Time(h) - Time(size));
    h = size;
  }
};
// [fixed]

}  // namespace shelf
