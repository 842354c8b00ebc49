// SPDX-License-Identifier: MIT-0
// The headers of this book on many planets.
#pragma once
#include <Eigen/Core>

#include "many/orbits.h"
#include "orbit/with_headers.h"

namespace many::with_headers {

using Numbers = Eigen::Array<double, count, 1>;

/// The positions, or the velocities, of all planets as one `Vec`: a column for each coordinate.
using Block = Eigen::Array<double, count, 2>;

inline Block block(const std::array<double, count>& x, const std::array<double, count>& y) {
  Block both;
  both << Eigen::Map<const Numbers>(x.data()), Eigen::Map<const Numbers>(y.data());
  return both;
}

inline Orbits orbits(const Block& x, const Block& v) {
  Orbits all;
  Eigen::Map<Numbers>(all.x.data()) = x.col(0);
  Eigen::Map<Numbers>(all.y.data()) = x.col(1);
  Eigen::Map<Numbers>(all.vx.data()) = v.col(0);
  Eigen::Map<Numbers>(all.vy.data()) = v.col(1);
  return all;
}

inline Block gravity(const Block& x, const Block&, double) {
  const Numbers r2 = x.col(0).square() + x.col(1).square();
  const Numbers pull = -1 / (r2 * r2.sqrt());
  Block a;
  a.col(0) = pull * x.col(0);
  a.col(1) = pull * x.col(1);
  return a;
}

template <class Step>
Orbits in_blocks(const Orbits& start, long steps, double h, Step step) {
  Block x = block(start.x, start.y);
  Block v = block(start.vx, start.vy);
  for (long n = 0; n < steps; ++n) step(x, v, double(n) * h, h, gravity);
  return orbits(x, v);
}

/// One planet after the other; whether the compiler takes several at once is its own affair.
template <class Step>
Orbits one_by_one(const Orbits& start, long steps, double h, Step step) {
  Orbits all = start;
  for (long n = 0; n < steps; ++n) {
    for (std::size_t i = 0; i < count; ++i) {
      orbit::Pair x{all.x[i], all.y[i]};
      orbit::Pair v{all.vx[i], all.vy[i]};
      step(x, v, double(n) * h, h, orbit::Gravity());
      all.x[i] = x.x, all.y[i] = x.y, all.vx[i] = v.x, all.vy[i] = v.y;
    }
  }
  return all;
}

}  // namespace many::with_headers
