// SPDX-License-Identifier: MIT-0
/// @file
/// The entries of a contest, and which is better.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "choose/attempt.h"
#include "choose/words.h"

/// The result of a method in the contest.
struct Entry {
  std::string name;                         ///< "exact step", or what the book calls the method
  const measure::Method* method = nullptr;  ///< never null
  Attempt last{};             ///< the first that is good enough; if none is, the nearest miss
  Attempt before{};           ///< with one step less; none if its `substeps` are zero
  bool good = false;          ///< whether `last` meets the bounds
  long tried = 0;             ///< steps in a frame at which the doubling ended
  double evaluations = 0;     ///< in a second of play, for `last`
  double microseconds = NAN;  ///< in a frame, for a thousand bodies, as recorded; NaN if it isn't
  double uneven = 0;          ///< the error of `last` in frames as uneven as recorded ones
  std::vector<Attempt> on_the_way{};  ///< what the doubling tried
};

/// An error without what is only rounding.
inline double without_rounding(double error) {
  return error < 1e-11 ? 0 : std::stod(format_number(error, 6));
}

/// Returns whether an entry is right in even frames alone.
inline bool is_for_even_frames(const Entry& entry, const Bounds& bounds) {
  return entry.good && !(entry.uneven <= bounds.error);
}

/// Good before not good, then cheap before dear, then what is right in uneven frames as well, then
/// right before nearly right, also in uneven frames; the nearest miss first among those that are
/// not good. Of equals velocity Verlet, which has place and velocity at the same time, and else by
/// the alphabet.
inline bool better(const Entry& a, const Entry& b, const Bounds& bounds) {
  if (a.good != b.good) return a.good;
  const double missed = miss(a.last, bounds), other_missed = miss(b.last, bounds);
  if (!a.good && missed != other_missed) return missed < other_missed;
  if (a.evaluations != b.evaluations) return a.evaluations < b.evaluations;
  const bool shaky = is_for_even_frames(a, bounds), other_shaky = is_for_even_frames(b, bounds);
  if (shaky != other_shaky) return other_shaky;
  const double one = without_rounding(a.last.error), other = without_rounding(b.last.error);
  if (one != other) return one < other;
  const double uneven = without_rounding(a.uneven), other_uneven = without_rounding(b.uneven);
  if (uneven != other_uneven) return uneven < other_uneven;
  const bool verlet = a.method == &method::velocity_verlet,
             other_verlet = b.method == &method::velocity_verlet;
  return verlet != other_verlet ? verlet : a.method->function < b.method->function;
}

/// All entries for a scene, the best first.
struct Contest {
  std::vector<Entry> exact;            ///< the exact steps, as exact_steps_of() has them
  std::vector<Entry> methods;          ///< what works with other forces added, too
  std::vector<Entry> undisturbed;      ///< adaptive steps, for what moves with nobody interfering
  bool keeps_energy = false;           ///< whether the scene's energy ought to stay what it is
  std::vector<std::string> remarks{};  ///< what else is to be said of the scene; some may be empty
  std::string warning{};  ///< why not to trust the answer; empty if nothing speaks against it

  void sort(const Bounds& bounds) {
    std::sort(methods.begin(), methods.end(),
              [&](const Entry& a, const Entry& b) { return better(a, b, bounds); });
  }
};

/// The entry of one of the methods that entered a contest.
inline const Entry& entry_of(const Contest& found, const measure::Method& method) {
  return *std::find_if(found.methods.begin(), found.methods.end(),
                       [&](const Entry& entry) { return entry.method == &method; });
}

/// The least that an entry within the bounds costs; infinite if there is none.
inline double cheapest_of(const std::vector<Entry>& entries) {
  double least = INFINITY;
  for (const Entry& entry : entries) {
    if (entry.good) least = std::min(least, entry.evaluations);
  }
  return least;
}

/// Returns whether anything that goes on in frames, or is exact, meets the bounds.
inline bool is_met(const Contest& found) {
  return found.methods.front().good || (!found.exact.empty() && found.exact.front().good);
}

/// The cheapest by time of those within the bounds; null if nobody took a time of any.
inline const Entry* cheapest_by_time(const std::vector<Entry>& entries) {
  const Entry* best = nullptr;
  for (const Entry& entry : entries) {
    if (!entry.good || std::isnan(entry.microseconds)) continue;
    if (!best || entry.microseconds < best->microseconds) best = &entry;
  }
  return best;
}
