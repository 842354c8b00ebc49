// SPDX-License-Identifier: MIT-0
/// @file
/// Diagnoses of a chain's end that misses its two lines.
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "format_values.h"
#include "scene.h"

namespace judge::chain_of_beads {

inline std::size_t worst(const Chain& chain, const Beads& end) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < chain.count(); ++i) {
    if (!std::isfinite(chain.miss(end, i))) return i;
    if (chain.miss(end, i) > chain.miss(end, found)) found = i;
  }
  return found;
}

inline std::string who_misses(const Chain& chain, const Beads& end, double within) {
  std::size_t count = 0, first = 0;
  for (std::size_t i = chain.count(); i-- > 0;) {
    if (chain.miss(end, i) <= within) continue;
    ++count;
    first = i;
  }
  return "the two lines do not hold at " + std::to_string(count) + " of " +
         std::to_string(chain.count()) + " beads, first at bead " + std::to_string(first);
}

// Says how far the worst line is met, where none is met and all are nearly.
inline std::string nearly_met(const Chain& chain, const Beads& end) {
  const double at_first = chain.miss(chain.start, worst(chain, chain.start));
  const double left = chain.miss(end, worst(chain, end)) / at_first;
  if (!(left > 1e-5 && left < 0.1)) return "";
  return "the worst line is missed by " + grade::number(100 * left, 2) +
         " % of what no step at all would miss: an iteration that was ended too soon?";
}

inline std::vector<std::string> what_is_wrong(const Chain& chain, const Beads& end, double within) {
  for (std::size_t i = 0; i < chain.count(); ++i)
    if (!std::isfinite(end.x[i]) || !std::isfinite(end.v[i]))
      return {"at bead " + std::to_string(i) + " this is not a finite number: a division by zero?"};
  const std::string nearly = nearly_met(chain, end);
  return {nearly.empty() ? who_misses(chain, end, within) : nearly};
}

}  // namespace judge::chain_of_beads
