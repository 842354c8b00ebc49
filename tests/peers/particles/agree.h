// SPDX-License-Identifier: MIT-0
// Before anything is timed: do all variants move the particles alike?
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "particles/variants.h"

namespace particles {

/// Where the formula leads, in double precision.
template <class Real>
Arrays<double> by_hand(const Arrays<Real>& start, int steps) {
  Arrays<double> p;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    p.x[axis] = start.x[axis].template cast<double>();
    p.v[axis] = start.v[axis].template cast<double>();
    for (int n = 0; n < steps; ++n) {
      p.v[axis] += (gravity[axis] - 4 * p.x[axis] - 0.1 * p.v[axis]) / 60;
      p.x[axis] += p.v[axis] / 60;
    }
  }
  return p;
}

template <class Real>
double distance(const Arrays<Real>& a, const Arrays<double>& b) {
  double most = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto x = (a.x[axis].template cast<double>() - b.x[axis]).abs().maxCoeff();
    const auto v = (a.v[axis].template cast<double>() - b.v[axis]).abs().maxCoeff();
    most = std::max({most, x, v});
  }
  return most;
}

template <class Real>
Arrays<Real> as_arrays(const std::vector<Particle<Real>>& structs) {
  Arrays<Real> p;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    p.x[axis].resize(long(structs.size()));
    p.v[axis].resize(long(structs.size()));
    for (std::size_t n = 0; n < structs.size(); ++n) {
      p.x[axis][long(n)] = structs[n].x[long(axis)];
      p.v[axis][long(n)] = structs[n].v[long(axis)];
    }
  }
  return p;
}

/// A variant moves one of the two layouts, and the other one stays where it was. Each step rounds a
/// dozen times, numbers of up to five.
template <class Real>
bool agree() {
  constexpr long count = 4 * Block<Real>::SizeAtCompileTime;
  constexpr int steps = 2 * substeps;
  constexpr double rounding = steps * 12 * 5 * double(std::numeric_limits<Real>::epsilon());
  bool all = true;
  for (const Variant<Real>& variant : variants<Real>()) {
    Particles<Real> p(count);
    const Arrays<double> right = by_hand(p.arrays, steps);
    for (int n = 0; n < steps; n += variant.steps) {
      variant.run(p, {0, count / 2});
      if (variant.threads > 1) variant.run(p, {count / 2, count});
    }
    const double away = std::min(distance(p.arrays, right), distance(as_arrays(p.structs), right));
    if (away <= rounding) continue;
    std::fprintf(stderr, "particles: %s ends %g from where the formula by hand ends\n",
                 variant.name.c_str(), away);
    all = false;
  }
  return all;
}

}  // namespace particles
