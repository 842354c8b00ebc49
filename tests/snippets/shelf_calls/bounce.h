// SPDX-License-Identifier: MIT-0
#pragma once
#include "numbers.h"

template <class Kind>
void bounce_on(Numbers& found) {
  using Real = typename Kind::Real;
  using Vec = typename Kind::Vec;
  const auto add = [&](const shelf::Impact<Real>& impact) {
    found.add(double(impact.hit));
    found.add(double(impact.time));
  };
  add(shelf::impact_plane(Real(1), Real(-4), Real(-8), Real(0.5)));
  add(shelf::impact_plane(Real(1), Real(4), Real(-8), Real(0.5)));
  const Real from[] = {-4, 1, Real(0.5)}, fast[] = {8, 0, 0}, down[] = {0, 0, -10},
             up[] = {0, 0, 1};
  Vec x = Kind::make(from), v = Kind::make(fast);
  const Vec gravity = Kind::make(down), normal = Kind::make(up);
  add(shelf::impact_sphere(x, v, Real(2), Real(1), Dot<Kind>()));
  add(shelf::impact_sphere(x, v, gravity, Real(2), Real(1), Dot<Kind>()));

  Vec turned = v + gravity;
  found.add(double(shelf::bounce(turned, normal, Real(0.5), Real(1), Dot<Kind>())));
  shelf::friction(turned, normal, Real(3), Dot<Kind>());
  add_all<Kind>(found, turned);

  const shelf::Plane<Vec, Real> floor{normal, 0, Real(0.5), Real(0.25), Real(1)};
  for (int n = 0; n < 8; ++n) {
    found.add(shelf::bounce_step(x, v, gravity, Real(0.25), floor, Dot<Kind>()));
    add_all<Kind>(found, x);
    add_all<Kind>(found, v);
  }
  const Real side[] = {Real(0.5), 0, Real(0.25)};
  const Vec moves = Kind::make(side);
  for (int n = 0; n < 8; ++n) {
    const shelf::MovingPlane<Vec, Real> before{floor, Real(n) / Real(8) * moves, moves},
        now{floor, Real(n + 1) / Real(8) * moves, moves};
    found.add(shelf::bounce_step(x, v, gravity, Real(0.125), before, now, Dot<Kind>()));
    add_all<Kind>(found, x);
    add_all<Kind>(found, v);
  }
}
