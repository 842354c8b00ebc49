// SPDX-License-Identifier: MIT-0
#pragma once
#include "numbers.h"

template <class Kind>
void event_on(Numbers& found) {
  using Vec = typename Kind::Vec;
  using Real = typename Kind::Real;
  struct Thing {
    Vec x, v;
  };
  const Real place[] = {1, 2, Real(0.5)}, speed[] = {Real(0.25), -8, -1};
  const Thing start{Kind::make(place), Kind::make(speed)};
  const auto step = [](Thing& one, Real h) { one.x = one.x + h * one.v; };
  for (const int axis : {0, 1, 2}) {
    const auto along = [axis](const Thing& one) { return Kind::read(one.x, axis); };
    const auto crossing = shelf::first_crossing(start, Real(1), step, along, 2);
    found.add(double(crossing.found));
    found.add(double(crossing.time));
  }
}
