// SPDX-License-Identifier: MIT-0
/// @file
/// Why an entry did not win.
#pragma once
#include <string>

#include "choose/entry.h"

/// The bound that an attempt missed, in words.
inline std::string shortcoming(const Attempt& attempt, const Bounds& bounds) {
  if (!(attempt.error < 10)) return "explodes";
  if (attempt.error > bounds.error)
    return "error " + format_above(in_reported_units(attempt.error, bounds),
                                   in_reported_units(bounds.error, bounds));
  return "energy off by " + format_above(attempt.energy, bounds.energy);
}

/// The reason why an entry did not win, or why it takes no step fewer.
inline std::string reason(const Entry& entry, const Bounds& bounds) {
  const Attempt& fails = entry.good ? entry.before : entry.last;
  if (fails.substeps == 0) return "one step is enough";
  return shortcoming(fails, bounds) + (entry.good ? " in " : " even in ") + steps(fails.substeps);
}
