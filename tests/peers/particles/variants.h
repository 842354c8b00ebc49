// SPDX-License-Identifier: MIT-0
// The ways to step many particles, in the order of the report.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "particles/arrays.h"
#include "particles/structs.h"

namespace particles {

/// The same particles twice, once in each layout.
template <class Real>
struct Particles {
  Arrays<Real> arrays;
  std::vector<Particle<Real>> structs;

  explicit Particles(long count) : structs(std::size_t(count)) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      arrays.x[axis] = Array<Real>::LinSpaced(count, Real(-1), Real(axis + 1));
      arrays.v[axis] = Array<Real>::LinSpaced(count, Real(axis), Real(-2));
      for (std::size_t n = 0; n < structs.size(); ++n) {
        structs[n].x[long(axis)] = arrays.x[axis][long(n)];
        structs[n].v[long(axis)] = arrays.v[axis][long(n)];
      }
    }
  }
};

constexpr int substeps = 16;

/// The length of a step, or of a substep [s].
template <class Real>
constexpr Real h = Real(1) / Real(60);

template <class Real>
struct Variant {
  std::string name, note;
  int steps;    ///< in one call
  int threads;  ///< among how many it can be shared
  void (*run)(Particles<Real>&, Range);
};

template <class Real>
Variant<Real> limit() {
  return {"limit of memory", "every number read, changed and written in place, and that is all", 1,
          2, [](Particles<Real>& p, Range r) { read_and_write(p.arrays, r); }};
}

template <class Real>
std::vector<Variant<Real>> variants() {
  return {
      {"header, number by number", "structure of arrays; Vec is the number, the loop a plain one",
       1, 2, [](Particles<Real>& p, Range r) { step_numbers(p.arrays, r, h<Real>); }},
      {"header, blocks, 16 substeps",
       "structure of arrays; Vec is a small Eigen array; the time is that of a substep", substeps,
       2, [](Particles<Real>& p, Range r) { step_blocks(p.arrays, r, h<Real>, substeps); }},
      {"header, blocks, 16 substeps, h = 1",
       "time counted in substeps: what h would multiply is only added, beside the multiplying",
       substeps, 2,
       [](Particles<Real>& p, Range r) { step_blocks_by_one(p.arrays, r, h<Real>, substeps); }},
      {"header, array of structs", "Vec is Eigen's vector of three", 1, 2,
       [](Particles<Real>& p, Range r) { step_structs(p.structs, r, h<Real>); }},
      {"whole arrays by hand", "two passes over memory", 1, 1,
       [](Particles<Real>& p, Range) { step_whole_by_hand(p.arrays, h<Real>); }},
      {"header, whole arrays", "trap: Vec is a whole array, and each temporary is one too", 1, 1,
       [](Particles<Real>& p, Range) { step_whole(p.arrays, h<Real>); }},
  };
}

}  // namespace particles
