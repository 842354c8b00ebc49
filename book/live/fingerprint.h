// SPDX-License-Identifier: MIT-0
/// @file
/// A number that tells two trajectories apart by their last bit.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

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

/// The fingerprint of a run from its start: of all that is shown anew after each step and is meant
/// to have the same bits everywhere.
/// @param steps  how many steps the run has
inline std::uint64_t fingerprint(Figure& figure, int steps) {
  Hash hash;
  std::vector<long> seen;
  figure.begin();
  for (int n = 0; n < steps; ++n) {
    figure.advance(1);
    const std::vector<Shown>& all = figure.shown();
    seen.resize(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!all[i].reproducible || all[i].changes == seen[i]) continue;
      seen[i] = all[i].changes;
      for (const double x : all[i].values) hash.add(x);
    }
  }
  return hash.value;
}

}  // namespace live
