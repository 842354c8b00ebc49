// SPDX-License-Identifier: MIT-0
/// @file
/// The suspension under steps that are not all of one length.
#pragma once
#include <algorithm>
#include <cmath>
#include <random>

#include "integrate/symplectic_euler.h"
#include "integrate/velocity_verlet.h"
#include "measure/record.h"
#include "shadow.h"

/// Steps of a sixtieth of a second, each longer or shorter by up to a share of it, at random. The
/// generator is one that the language standard fixes to the bit.
struct UnevenSteps {
  double share = 0.5;
  std::mt19937 random;

  double next() { return frame * (1 + share * (double(random()) / 2147483648.0 - 1)); }
};

/// How far the suspension swings under two methods, on the same steps [m].
struct Swings {
  double symplectic_euler = 0, velocity_verlet = 0;
};

inline Swings uneven_swings(double share, unsigned seed, long steps) {
  UnevenSteps uneven{.share = share, .random = std::mt19937(seed)};
  auto swapped = undamped_suspension.start(), verlet = undamped_suspension.start();
  double a = integrate::velocity_verlet_start(verlet.x, verlet.v, 0.0, undamped_suspension);
  Swings farthest;
  for (long n = 0; n < steps; ++n) {
    const double h = uneven.next();
    integrate::symplectic_euler(swapped.x, swapped.v, 0.0, h, undamped_suspension);
    integrate::velocity_verlet(verlet.x, verlet.v, a, 0.0, h, undamped_suspension);
    farthest.symplectic_euler = std::max(farthest.symplectic_euler, std::abs(swapped.x));
    farthest.velocity_verlet = std::max(farthest.velocity_verlet, std::abs(verlet.x));
  }
  return farthest;
}

inline void uneven_steps(measure::Record& record) {
  constexpr unsigned seed = 1;
  record.number("uneven-ten", uneven_swings(0.5, seed, 600 * 60).symplectic_euler, 2, "m");
  const Swings hour = uneven_swings(0.5, seed, 3600 * 60);
  record.number("uneven-hour", hour.symplectic_euler / 1e12, 1, "billion km");
  record.number("uneven-verlet", 100 * hour.velocity_verlet, 2, "cm");
}
