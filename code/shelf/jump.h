// SPDX-License-Identifier: MIT-0
/// @file
/// The jump of a platformer: as high and as long as the designer says, in frames of any length.
///
/// @code
/// // 4 m high and 0.44 s to the top, down in 0.3 s; a tap of the button jumps 1 m high.
/// const auto jump = shelf::jump_to(4.0, 0.44);
/// const double falling = shelf::jump_to(4.0, 0.3).gravity;
/// const double released = shelf::jump_gravity(jump.speed, 1.0);
/// double height = 0, speed = jump.speed;
/// for (int n = 0; n < 22; ++n) {
///   shelf::jump_step(height, speed, jump.gravity, falling, 1 / 50.0);
/// }
/// double tapped = 0, tapped_speed = jump.speed;
/// const double frames[] = {0.01, 0.03, 0.07};
/// for (const double frame : frames) {
///   shelf::jump_step(tapped, tapped_speed, released, falling, frame);
/// }
/// // Now height is 4.0000.
/// // Now tapped is 1.0000.
/// @endcode
///
/// On the way up hand over `jump.gravity` while the button is held. From the frame on in which it
/// is let go, hand over `released`, which is stronger, so that the jump ends lower. The last pull
/// is that of the way down. In which part of a frame the top lies makes no difference, since there
/// the step is taken in two. Steps that change the velocity first lose height, and more of it where
/// frames are longer. That a player may jump a little after he left the edge is a timer of your
/// own. Jumps are as alike as your buttons: seen once a frame, they are late by up to a frame.
/// Stamp them with their time, and end a step there.
///
/// When the ground is reached, `impact_plane` of bounce.h says, for a step under one pull. In most
/// games it is enough to put the player onto the ground where a step ended below it.
///
/// Promises:
/// - after the time that was asked for it is as high as was asked for, and at its top, to 1e-13 of
///   it, in 1 step and in 1000
/// - held all the way it is where a stone would be that is thrown under the one pull and falls
///   under the other, to 1e-12 of the height, at 15 to 1000 Hz and in recorded frames
/// - let go after a tenth of a second, too, by frames of any length
/// - let go at once it rises as high as was asked for, to 1e-15 of it
/// - of 4 m a step that changes the velocity first reaches 3.82 at 50 Hz and 3.42 at 15 Hz
#pragma once
#include <type_traits>

namespace shelf {

/// How a jump begins, and what pulls it down while it rises.
template <class Real>
struct Jump {
  Real speed;    ///< upwards, as it leaves the ground [m/s]
  Real gravity;  ///< downwards [m/s^2]
};

/// The jump that is at its top so high, after so long.
///
/// @param height  of the top above the start [m]; not negative
/// @param time  from the start to the top [s]; above zero
/// @returns  2 H / T and 2 H / T^2
template <class Real>
constexpr Jump<Real> jump_to(Real height, Real time) {
  static_assert(!std::is_integral_v<Real>, "height and time must be no integers");
  const Real speed = Real(2) * height / time;
  return {speed, speed / time};
}

/// The pull under which what rises with this speed has its top so much higher: for a button that is
/// let go, and so for the lowest jump, where it is let go at once.
///
/// @param speed  upwards [m/s]
/// @param height  still to rise [m]; above zero
/// @returns  v^2 / (2 H), downwards [m/s^2]
template <class Real>
constexpr Real jump_gravity(Real speed, Real height) {
  static_assert(!std::is_integral_v<Real>, "speed and height must be no integers");
  return speed * (speed / (Real(2) * height));
}

/// One step of a jump or a fall, exact for any h: one pull while it rises, another while it falls.
///
/// Where the top comes within the step, it is reached under the one and left under the other. Calls
/// nothing of the C library.
///
/// @param x  height, advanced in place [m]
/// @param v  speed upwards, advanced in place [m/s]
/// @param rising  pull downwards while v is above zero [m/s^2]; not negative
/// @param falling  pull downwards from the top on [m/s^2]
/// @param h  step size [s]; not negative
template <class Real>
constexpr void jump_step(Real& x, Real& v, Real rising, Real falling, Real h) {
  static_assert(!std::is_integral_v<Real>, "x, v and h must be no integers");
  // [jump]
  if (v > Real(0) && v < rising * h) {
    const Real up = v / rising;
    x = x + up * v / Real(2);
    v = Real(0);
    h = h - up;
  }
  const Real pull = v > Real(0) ? rising : falling;
  x = x + h * v - (h * h / Real(2)) * pull;
  v = v - h * pull;
  // [jump]
}

}  // namespace shelf
