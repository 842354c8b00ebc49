// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The place to which a strong hand would bring the crate, and as much of the way there, beyond
// where it goes by itself, as the hand can give.
inline double end(double x, double v, double h, double hand, double omega, double zeta) {
  const double pull = (h * omega) * (h * omega), brake = 1 + 2 * zeta * h * omega;
  return (brake * x + h * v + pull * hand) / (brake + pull);
}

inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta,
                 double strongest) {
  const Vec by_itself = x + h * v;
  const Vec next{end(x.x, v.x, h, hand.x, omega, zeta), end(x.y, v.y, h, hand.y, omega, zeta),
                 end(x.z, v.z, h, hand.z, omega, zeta)};
  Vec way = next - by_itself;
  const double most = h * h * strongest;
  if (dot(way, way) > most * most) way *= most / length(way);
  x = by_itself + way;
  v += way / h;
}
