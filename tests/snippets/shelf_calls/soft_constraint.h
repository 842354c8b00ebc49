// SPDX-License-Identifier: MIT-0
#pragma once
#include "numbers.h"

template <class Kind>
void soft_constraint_on(Numbers& found) {
  using Real = typename Kind::Real;
  using Vec = typename Kind::Vec;
  const Real first[] = {1, -3, 4}, second[] = {2, Real(0.5), Real(0.25)},
             line[] = {Real(0.6), 0, Real(0.8)};
  Vec v1 = Kind::make(first), v2 = Kind::make(second);
  const Vec along = Kind::make(line);
  Real impulse = Real(0.5);
  for (const Real omega : {Real(0), Real(2), Real(50)}) {
    const shelf::Softness<Real> soft = shelf::softness(Real(0.125), omega, Real(0.5));
    shelf::soft_warm_start(v1, v2, impulse, along, Real(1), Real(0.25));
    shelf::soft_constraint(v1, v2, impulse, along, Real(0.25), Real(1), Real(0.25), soft,
                           Dot<Kind>());
    add_all<Kind>(found, v1);
    add_all<Kind>(found, v2);
    found.add(double(impulse));
  }
  for (const Real zeta : {Real(0), Real(0.5), Real(2)}) {
    const shelf::SoftMotion<Real> real = shelf::soft_motion(Real(0.125), Real(4), zeta);
    found.add(double(real.omega));
    found.add(double(real.zeta));
    found.add(double(real.swing));
  }
}
