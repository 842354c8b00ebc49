// SPDX-License-Identifier: MIT-0
// The loop vectorised by hand: as many planets at once as a register holds.
#pragma once
#include <experimental/simd>

#include "many/orbits.h"

namespace many::by_hand {

using Pack = std::experimental::native_simd<double>;
constexpr std::size_t packs = count / Pack::size();

struct Packed {
  std::array<Pack, packs> x, y, vx, vy;

  explicit Packed(const Orbits& all) {
    for (std::size_t i = 0; i < packs; ++i) {
      const auto from = [i](const auto& numbers) {
        return Pack(&numbers[i * Pack::size()], std::experimental::vector_aligned);
      };
      x[i] = from(all.x), y[i] = from(all.y), vx[i] = from(all.vx), vy[i] = from(all.vy);
    }
  }

  Orbits unpacked() const {
    Orbits all;
    for (std::size_t i = 0; i < packs; ++i) {
      const auto to = [i](const Pack& pack, auto& numbers) {
        pack.copy_to(&numbers[i * Pack::size()], std::experimental::vector_aligned);
      };
      to(x[i], all.x), to(y[i], all.y), to(vx[i], all.vx), to(vy[i], all.vy);
    }
    return all;
  }
};

inline Pack pull(const Pack& r2) {
  return -1 / (r2 * sqrt(r2));
}

inline Orbits symplectic_euler(const Orbits& start, long steps, double h) {
  Packed p(start);
  for (long n = 0; n < steps; ++n) {
    for (std::size_t i = 0; i < packs; ++i) {
      const Pack f = h * pull(p.x[i] * p.x[i] + p.y[i] * p.y[i]);
      p.vx[i] += f * p.x[i];
      p.vy[i] += f * p.y[i];
      p.x[i] += h * p.vx[i];
      p.y[i] += h * p.vy[i];
    }
  }
  return p.unpacked();
}

inline Orbits rk4(const Orbits& start, long steps, double h) {
  Packed p(start);
  const double half = h / 2;
  for (long n = 0; n < steps; ++n) {
    for (std::size_t i = 0; i < packs; ++i) {
      const Pack x = p.x[i], y = p.y[i], vx = p.vx[i], vy = p.vy[i];
      const Pack p1 = pull(x * x + y * y);
      const Pack ax1 = p1 * x, ay1 = p1 * y;
      const Pack vx2 = vx + half * ax1, vy2 = vy + half * ay1;
      const Pack x2 = x + half * vx, y2 = y + half * vy;
      const Pack p2 = pull(x2 * x2 + y2 * y2);
      const Pack ax2 = p2 * x2, ay2 = p2 * y2;
      const Pack vx3 = vx + half * ax2, vy3 = vy + half * ay2;
      const Pack x3 = x + half * vx2, y3 = y + half * vy2;
      const Pack p3 = pull(x3 * x3 + y3 * y3);
      const Pack ax3 = p3 * x3, ay3 = p3 * y3;
      const Pack vx4 = vx + h * ax3, vy4 = vy + h * ay3;
      const Pack x4 = x + h * vx3, y4 = y + h * vy3;
      const Pack p4 = pull(x4 * x4 + y4 * y4);
      p.x[i] = x + h / 6 * (vx + 2 * (vx2 + vx3) + vx4);
      p.y[i] = y + h / 6 * (vy + 2 * (vy2 + vy3) + vy4);
      p.vx[i] = vx + h / 6 * (ax1 + 2 * (ax2 + ax3) + p4 * x4);
      p.vy[i] = vy + h / 6 * (ay1 + 2 * (ay2 + ay3) + p4 * y4);
    }
  }
  return p.unpacked();
}

}  // namespace many::by_hand
