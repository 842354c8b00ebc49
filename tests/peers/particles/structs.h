// SPDX-License-Identifier: MIT-0
// Particles as everyone writes them: an array of structs.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "integrate/symplectic_euler.h"
#include "particles/arrays.h"

namespace particles {

template <class Real>
struct Particle {
  Eigen::Matrix<Real, 3, 1> x, v;
};

template <class Real>
void step_structs(std::vector<Particle<Real>>& all, Range range, Real h) {
  using Vec = Eigen::Matrix<Real, 3, 1>;
  constexpr Forces<Real> f{Real(gravity[1])};
  const auto acceleration = [f](const Vec& x, const Vec& v, Real) -> Vec {
    return Vec(0, f.gravity, 0) - f.stiffness * x - f.drag * v;
  };
  for (long n = range.first; n < range.last; ++n) {
    Particle<Real>& p = all[std::size_t(n)];
    integrate::symplectic_euler(p.x, p.v, Real(0), h, acceleration);
  }
}

}  // namespace particles
