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

inline void settle(double& x, double& v, double target, double omega, double h) {
  const Left left = later({x - target, v}, omega, h);
  x = left.way + target;
  v = left.speed;
}
