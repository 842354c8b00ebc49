// SPDX-License-Identifier: MIT-0
// The problem on which the methods are compared with their textbook formulas, and what both sides
// are written in.
#pragma once
#include <cmath>
#include <functional>

#include "scenes/state.h"

namespace textbook {

// Not linear, with every argument in it, and special at no time. Its numbers are the same in float
// as in long double; in x and v it is a polynomial, which differences differentiate exactly.
struct Pushed {
  template <class Real, class Time>
  Real operator()(const Real& x, const Real& v, Time t) const {
    const Real push = wave<Real>(t);
    return Real(0.3125) - x * x * x - Real(0.25) * v * v * v + push + Real(0.1875) * push * x * v;
  }

  template <class Real, class Time, class Add>
  void jacobian(const Real& x, const Real& v, Time t, Add&& add) const {
    const Real push = wave<Real>(t);
    add(0, 0, Real(-3) * x * x + Real(0.1875) * push * v,
        Real(-0.75) * v * v + Real(0.1875) * push * x);
  }

 private:
  template <class Real, class Time>
  static Real wave(Time t) {
    return std::sin(Real(1.75) * Real(t) + Real(0.375));
  }
};

// The textbooks' side, in long double: what differs is the rounding of the header's side.
using Real = long double;
using State = scenes::State<Real>;
using Force = std::function<Real(Real x, Real v, Real t)>;

}  // namespace textbook
