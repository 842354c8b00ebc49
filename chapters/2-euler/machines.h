// SPDX-License-Identifier: MIT-0
/// @file
/// Machines with other frame rates, and on each of them two cameras that follow one target.
#pragma once
#include <cmath>

#include "shelf/smooth_damp.h"

/// The rate at which smoothing goes a tenth of the way in a frame at sixty frames a second [1/s].
inline const double tuned = -60 * std::log(0.9);

/// A machine that draws a frame with each refresh of its screen, unless a frame comes late.
template <class Vec>
struct Machine {
  double rate;      ///< refreshes a second [Hz]
  Vec lerp, exact;  ///< its two cameras in the frame that is shown
  Vec aim;          ///< the target, as the frame on the way found it
  long shown = 0;   ///< refreshes until the last frame
  long next = 1;    ///< and until the one on the way
  long late = 1;    ///< refreshes that a late frame takes; one a second is late
  bool is_late() const { return std::fmod(double(shown), rate) == std::floor(rate / 10); }

  /// Both cameras in a frame of length h.
  void frame_of(double h) {
    const Vec& target = aim;
    const Vec at_rest = target - target;
    // [cameras]
    lerp = lerp + 0.1 * (target - lerp);
    shelf::smooth(exact, target, at_rest, tuned, h);
    // [cameras]
  }

  /// Draws what is due after so many refreshes.
  /// @param target  callable `(double) -> Vec`, where the target is at a time [s]
  template <class Target>
  void draw_until(double refreshes, Target&& target) {
    for (; double(next) <= refreshes; next = shown + (is_late() ? late : 1)) {
      frame_of(double(next - shown) / rate);
      shown = next;
      aim = target(double(shown) / rate);
    }
  }
};

/// The two cameras of a machine after its target jumped ten metres away: calls `look(machine)`
/// after each refresh of half a second.
/// @param late  refreshes that the frame takes which begins after a tenth of a second
template <class Look>
void after_a_jump(double rate, long late, Look&& look) {
  Machine<double> machine{.rate = rate, .lerp = 0, .exact = 0, .aim = 10, .late = late};
  for (int n = 0; n <= rate / 2; ++n) {
    machine.draw_until(n, [](double) { return 10.0; });
    look(machine);
  }
}
