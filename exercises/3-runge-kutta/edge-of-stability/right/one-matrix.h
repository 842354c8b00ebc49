// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

struct Pair {
  double x, v;
};

// A step of RK4 for a spring of omega = 1, from the start that is given.
inline Pair step(Pair s, double h, double zeta) {
  const auto slope = [&](Pair at) { return Pair{at.v, -at.x - 2 * zeta * at.v}; };
  Pair sum = s, term = s;
  for (int power = 1; power <= 4; ++power) {
    const Pair next = slope(term);
    term = {h / power * next.x, h / power * next.v};
    sum = {sum.x + term.x, sum.v + term.v};
  }
  return sum;
}

// The larger eigenvalue of the four numbers that a step comes down to.
inline double radius(double h, double zeta) {
  const Pair one = step({1, 0}, h, zeta), two = step({0, 1}, h, zeta);
  const double half_trace = (one.x + two.v) / 2, determinant = one.x * two.v - one.v * two.x;
  const double under_root = half_trace * half_trace - determinant;
  if (under_root <= 0) return std::sqrt(determinant);
  return std::abs(half_trace) + std::sqrt(under_root);
}

inline double stretch(double re, double im) {
  double sum_re = 1, sum_im = 0, term_re = 1, term_im = 0;
  for (int power = 1; power <= 4; ++power) {
    const double next_re = (term_re * re - term_im * im) / power;
    term_im = (term_re * im + term_im * re) / power;
    term_re = next_re;
    sum_re += term_re;
    sum_im += term_im;
  }
  return std::hypot(sum_re, sum_im);
}

inline double longest_step(double omega, double zeta) {
  double stable = 0, unstable = 10;
  while (unstable - stable > 1e-9 * unstable) {
    const double h = 0.5 * (stable + unstable);
    if (radius(h, zeta) <= 1) {
      stable = h;
    } else {
      unstable = h;
    }
  }
  return stable / omega;
}
