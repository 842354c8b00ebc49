// fails: the slope at the end leads back to the start
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// JAXsim's implicit integrator moved the base of its robots like this (gbionics/jaxsim, pull
// request 68).
inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta) {
  const Vec old = v;
  const double angle = h * omega;
  v = (v + angle * omega * (hand - x)) / (1 + 2 * zeta * angle + angle * angle);
  x += h * old;
}
