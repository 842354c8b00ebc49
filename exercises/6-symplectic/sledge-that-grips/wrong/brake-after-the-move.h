// fails: a few steps of a sledge are braked after the push, by division
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// As Rapier does: the velocity is right when it is read, and the sledge moved with another.
inline void step(Vec& x, Vec& v, double t, double h, const Vec& along, double c_along,
                 double c_across, const Acceleration& push) {
  v += h * push(x, v, t);
  x += h * v;
  const Vec glide = dot(v, along) * along;
  v = glide / (1 + c_along * h) + (v - glide) / (1 + c_across * h);
}
