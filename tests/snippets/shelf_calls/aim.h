// SPDX-License-Identifier: MIT-0
#pragma once
#include "numbers.h"

template <class Kind>
void aim_on(Numbers& found) {
  using Vec = typename Kind::Vec;
  using Real = typename Kind::Real;
  const Real start[] = {1, 2, 3}, speed[] = {4, -5, 6}, pull[] = {0, 0, -10}, goal[] = {7, -3, 1};
  const Vec a = Kind::make(pull), place = Kind::make(goal);
  const Real h = Real(1) / 16;
  const auto step = [&](Vec& x, Vec& v) {
    v = v + h * a;
    x = x + h * v;
  };
  const auto height = [](const Vec& x) { return Kind::read(x, 2); };
  const auto fall = shelf::landing(Kind::make(start), Kind::make(speed), h, Real(4), step, height);
  found.add(double(fall.found));
  found.add(double(fall.time));
  add_all<Kind>(found, fall.place);
  const auto target = [&](Real time) -> Vec { return place + time * a; };
  const shelf::Gun<Real> gun{Real(20), h, Real(4), Real(0.0078125)};
  const auto shot = shelf::aim(Kind::make(start), target, step, Dot<Kind>(), gun);
  found.add(double(shot.found));
}
