// SPDX-License-Identifier: MIT-0
#pragma once
#include "numbers.h"

template <class Kind>
void link_on(Numbers& found) {
  using Real = typename Kind::Real;
  using Vec = typename Kind::Vec;
  const Real first[] = {0, 0, 1}, second[] = {Real(0.75), 0, 1}, third[] = {1, Real(0.5), 1};
  const Real down[] = {0, 0, Real(-9.81)};
  Vec x1 = Kind::make(first), x2 = Kind::make(second);
  Real tension = 0;
  shelf::pull(x1, x2, Real(1), Real(0.5), Real(1), Length<Kind>());
  shelf::link(x1, x2, tension, Real(1), Real(0.5), Real(0.5), Real(0.25), Real(0.5),
              Length<Kind>());
  shelf::link_warm_start(x1, x2, tension, Real(1), Real(0), Real(0.5), Length<Kind>());
  add_all<Kind>(found, x1);
  add_all<Kind>(found, x2);
  found.add(double(tension));

  Vec x[] = {Kind::make(first), Kind::make(second), Kind::make(third)};
  Vec before[] = {x[0], x[1], x[2]};
  Real tensions[2] = {}, w[] = {0, 1, Real(0.5)};
  const Vec gravity = Kind::make(down);
  const auto floor = [](const Vec& place) {
    const Real up = Kind::read(place, 2), lowest = Real(0.875);
    const Real lifted[] = {Kind::read(place, 0), Kind::read(place, 1), up < lowest ? lowest : up};
    return Vec(Kind::make(lifted));
  };
  for (const bool warm : {false, true}) {
    const shelf::Rope<Real> rope{Real(0.625), Real(0.01), 2, warm};
    for (int n = 0; n < 5; ++n) {
      shelf::rope_step(x, before, tensions, w, 3, rope, gravity, Real(0.0625), Length<Kind>(),
                       floor);
    }
    for (const Vec& place : x) add_all<Kind>(found, place);
  }
}
