// SPDX-License-Identifier: MIT-0
#pragma once
#include <complex>

#include "given.h"

// Half a step of Euler's method, then half a step of backward Euler.
inline void leave(double& x, double& v, double h, double omega, double zeta) {
  const double a = -omega * omega * x - 2 * zeta * omega * v;
  x += h * v;
  v += h * a;
}

inline void arrive(double& x, double& v, double h, double omega, double zeta) {
  const double angle = h * omega;
  v = (v - angle * omega * x) / (1 + 2 * zeta * angle + angle * angle);
  x += h * v;
}

inline void step(double& x, double& v, double h, double omega, double zeta) {
  leave(x, v, h / 2, omega, zeta);
  arrive(x, v, h / 2, omega, zeta);
}

inline double told(double omega, double h) {
  const std::complex<double> turn = std::polar(1.0, omega * h);
  return 2 / h * ((turn - 1.0) / (turn + 1.0)).imag();
}
