// Fails: a few steps of a sledge are braked after the push, by division
// Says: this is a velocity that was split before the push, and the push braked along as a whole
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The parts are those of the velocity before the push.
inline void step(Vec& x, Vec& v, double t, double h, const Vec& along, double c_along,
                 double c_across, const Acceleration& push) {
  const Vec glide = dot(v, along) * along, slip = v - glide;
  const Vec a = push(x, v, t);
  v = (glide + h * a) / (1 + c_along * h) + slip / (1 + c_across * h);
  x += h * v;
}
