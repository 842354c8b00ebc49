// SPDX-License-Identifier: MIT-0
#pragma once
#include "numbers.h"

template <class Kind>
void smooth_damp_on(Numbers& found) {
  using Vec = typename Kind::Vec;
  using Real = typename Kind::Real;
  const Real start[] = {1, -3, 4}, speed[] = {2, Real(0.5), -9}, place[] = {-1, 2, Real(0.5)};
  const Real wind[] = {Real(0.25), 0, -1};
  const Vec target = Kind::make(place), target_velocity = Kind::make(wind);
  const Real h = Real(1) / 16;
  found.add(double(shelf::smoothing_share(Real(3), h)));
  Vec smoothed = Kind::make(start), x = smoothed, braked = smoothed;
  Vec v = Kind::make(speed), v_braked = v, limited = x, v_limited = v;
  for (int n = 0; n < 4; ++n) {
    shelf::smooth(smoothed, target, target_velocity, Real(3), h);
    shelf::smooth_damp(x, v, target, target_velocity, Real(2), h);
    shelf::smooth_damp_no_overshoot(braked, v_braked, target, target_velocity, Real(2), h,
                                    Dot<Kind>());
    shelf::smooth_damp_limited(limited, v_limited, target, target_velocity, Real(2), Real(3),
                               Real(40), h, Dot<Kind>());
  }
  for (const Vec& one : {smoothed, x, v, braked, v_braked, limited, v_limited})
    add_all<Kind>(found, one);
}
