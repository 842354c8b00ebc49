// SPDX-License-Identifier: MIT-0
// Particles as a structure of arrays, and the loops around the header that suit it.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "integrate/symplectic_euler.h"
#include "particles/forces.h"

namespace particles {

template <class Real>
using Array = Eigen::Array<Real, Eigen::Dynamic, 1>;

/// One array for each coordinate of the position and of the velocity.
template <class Real>
struct Arrays {
  std::array<Array<Real>, 3> x, v;
};

/// Which particles: those from `first` up to, but not including, `last`.
struct Range {
  long first, last;
};

template <class Real>
Forces<Real> forces_along(std::size_t axis) {
  return {Real(gravity[axis])};
}

/// The loop to write. A `Vec` is one number, and the compiler takes as many at once as fit.
template <class Real>
void step_numbers(Arrays<Real>& p, Range range, Real h) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Real* x = p.x[axis].data();
    Real* v = p.v[axis].data();
    for (long n = range.first; n < range.last; ++n) {
      integrate::symplectic_euler(x[n], v[n], Real(0), h, forces_along<Real>(axis));
    }
  }
}

/// As many numbers as eight of the widest registers hold: 64 doubles or 128 floats.
template <class Real>
using Block = Eigen::Array<Real, 512 / sizeof(Real), 1>;

/// Fetches block after block from memory, and puts each back when `work(axis, x, v)` is through.
/// @param range  whole blocks
template <class Real, class Work>
void for_each_block(Arrays<Real>& p, Range range, Work work) {
  constexpr long size = Block<Real>::SizeAtCompileTime;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (long n = range.first; n < range.last; n += size) {
      Block<Real> x = p.x[axis].template segment<size>(n);
      Block<Real> v = p.v[axis].template segment<size>(n);
      work(axis, x, v);
      p.x[axis].template segment<size>(n) = x;
      p.v[axis].template segment<size>(n) = v;
    }
  }
}

/// Many small steps for each trip to memory. Between them a block stays in the registers.
template <class Real>
void step_blocks(Arrays<Real>& p, Range range, Real h, int substeps) {
  for_each_block(p, range, [=](std::size_t axis, Block<Real>& x, Block<Real>& v) {
    for (int s = 0; s < substeps; ++s) {
      integrate::symplectic_euler(x, v, Real(0), h, forces_along<Real>(axis));
    }
  });
}

/// The same with time counted in substeps, so that `h` is 1 and multiplies nothing. Velocities are
/// metres for each substep, accelerations metres for each substep twice.
template <class Real>
void step_blocks_by_one(Arrays<Real>& p, Range range, Real h, int substeps) {
  for_each_block(p, range, [=](std::size_t axis, Block<Real>& x, Block<Real>& v) {
    const Forces<Real> f = forces_along<Real>(axis);
    const Forces<Real> scaled{h * h * f.gravity, h * h * f.stiffness, h * f.drag};
    v = h * v;
    for (int s = 0; s < substeps; ++s) {
      integrate::symplectic_euler(x, v, Real(0), Real(1), scaled);
    }
    v = (1 / h) * v;
  });
}

/// A `Vec` is a whole array, and so is everything that a step keeps for a moment.
template <class Real>
void step_whole(Arrays<Real>& p, Real h) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    integrate::symplectic_euler(p.x[axis], p.v[axis], Real(0), h, forces_along<Real>(axis));
  }
}

/// Whole arrays again, written out so that nothing is kept: two passes over memory, not one.
template <class Real>
void step_whole_by_hand(Arrays<Real>& p, Real h) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Forces<Real> f = forces_along<Real>(axis);
    p.v[axis] += h * (f.gravity - f.stiffness * p.x[axis] - f.drag * p.v[axis]);
    p.x[axis] += h * p.v[axis];
  }
}

/// The least that a step must do to memory: each number read, changed and written in its place. The
/// numbers draw near to 1, far from those that are slow to compute with.
template <class Real>
void read_and_write(Arrays<Real>& p, Range range) {
  for (auto* arrays : {&p.x, &p.v}) {
    for (Array<Real>& array : *arrays) {
      auto part = array.segment(range.first, range.last - range.first);
      part = Real(0.999) * part + Real(0.001);
    }
  }
}

}  // namespace particles
