// SPDX-License-Identifier: MIT-0
/// @file
/// A number that tells two trajectories apart by their last bit.
#pragma once
#include <bit>
#include <cstdint>
#include <limits>

#include "figure.h"

namespace live {

/// FNV-1a over doubles, one at a time. Every value that is not a number counts as the same one,
/// since WebAssembly leaves their bits open.
struct Hash {
  std::uint64_t value = 0xcbf29ce484222325;

  void add(double x) {
    const double same = x == x ? x : std::numeric_limits<double>::quiet_NaN();
    value = (value ^ std::bit_cast<std::uint64_t>(same)) * 0x100000001b3;
  }
};

/// The fingerprint of a run from its start: of all that is shown after each step and is meant to
/// have the same bits everywhere.
/// @param steps  how many steps the run has
inline std::uint64_t fingerprint(Figure& figure, int steps) {
  Hash hash;
  figure.start();
  for (int n = 0; n < steps; ++n) {
    figure.advance(1);
    for (const Shown& shown : figure.shown()) {
      if (!shown.reproducible) continue;
      for (const double x : shown.values) hash.add(x);
    }
  }
  return hash.value;
}

}  // namespace live
