// SPDX-License-Identifier: MIT-0
/// @file
/// A camera that follows by the frame, and a frame that comes late.
#pragma once
#include <algorithm>
#include <cmath>

#include "../cast.h"
#include "measure/methods.h"
#include "measure/record.h"
#include "shelf/smooth_damp.h"

inline constexpr double hitch_length = 0.1;  ///< of the third frame [s]

/// The camera in a frame after the other: how far it has gone by Euler's method, and exactly.
struct Hitch {
  double t = 0;               ///< [s]
  double euler = 0, v = 0;    ///< place and velocity by Euler's method
  double exact = 0, pan = 0;  ///< the same by the exact step

  /// Moves both cameras towards a target one metre away.
  /// @param h  how long the frame took [s]
  void frame_of(double h) {
    t += h;
    double way = euler - 1;
    integrate::euler(way, v, 0.0, h, camera);
    euler = way + 1;
    // [follow]
    shelf::smooth_damp(exact, pan, 1.0, 0.0, camera.omega, h);
    // [follow]
  }
};

/// Calls `look(hitch)` at the start and after each of some frames, of which the third comes late.
template <class Look>
void hitch(int frames, Look&& look) {
  Hitch h;
  look(h);
  for (int n = 1; n <= frames; ++n) {
    h.frame_of(n == 3 ? hitch_length : frame);
    look(h);
  }
}

/// Way left after half a second, out of ten metres, if a tenth of it is covered in each frame [m].
inline double left_by_lerp(int rate) {
  return 10 * std::pow(0.9, rate / 2);
}

/// A camera on a spring, and one that goes a tenth of the way in every frame.
inline void cameras(measure::Record& record) {
  auto& table = record.table("hitch", {{"t", "s"}, {"Euler", "m"}, {"exact", "m"}});
  double farthest = 0;
  hitch(18, [&](const Hitch& now) {
    table.add({now.t, now.euler, now.exact});
    farthest = std::max(farthest, now.euler);
  });
  record.number("hitch-past", farthest - 1, 3, "m");
  record.number("hitch-omega", camera.omega, measure::whole, "1/s");
  record.number("lerp-30", left_by_lerp(30), 2, "m");
  record.number("lerp-144", 1000 * left_by_lerp(144), 1, "mm");
  record.number("lerp-rate", -60 * std::log(0.9), 3, "per second");
}
