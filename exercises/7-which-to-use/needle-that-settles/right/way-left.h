// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// In terms of the way that is left, and put back at the end.
struct Left {
  double way, speed;
};

inline Left later(Left now, double omega, double h) {
  const double rate = now.speed + omega * now.way;
  const double way = now.way + rate * h;
  return {way * std::exp(-omega * h), (rate - omega * way) * std::exp(-omega * h)};
}

// A target that stands still where the needle's equilibrium is: the one that moves, and a way
// behind it on which the damper's drag and the spring are equal.
inline void settle(double& x, double& v, double target, double u, double omega, double h) {
  const double drag = 2 * omega * u, rest = target - drag / (omega * omega);
  const Left left = later({x - rest, v - u}, omega, h);
  x = left.way + (rest + u * h);
  v = left.speed + u;
}
