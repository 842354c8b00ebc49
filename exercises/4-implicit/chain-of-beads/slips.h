// SPDX-License-Identifier: MIT-0
/// @file
/// What a wrong end of a chain's step often is.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "chain.h"
#include "format_values.h"

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

// By how much the end misses row i of (own + h^2 K) v = v_old + h a(x_old), with the K of one chain
// and the a of another [m/s].
inline double row(const Beads& end, const Chain& matrix, const Chain& right, std::size_t i,
                  double own = 1) {
  const double h = matrix.h;
  const double back = h * h * matrix.acceleration({end.v, {}}, i);
  return std::abs(own * end.v[i] - back - right.start.v[i] -
                  h * right.acceleration(right.start, i));
}

inline bool solves(const Beads& end, const Chain& matrix, const Chain& right, double within,
                   double own = 1) {
  for (std::size_t i = 0; i < matrix.count(); ++i)
    if (!(row(end, matrix, right, i, own) <= within)) return false;
  return true;
}

// A system with a slip in one of its parts.
inline std::string wrong_system(const Chain& chain, const Beads& end, double within) {
  const auto times = [&](double factor) {
    Chain other = chain;
    for (double& stiffness : other.k) stiffness *= factor;
    return other;
  };
  Chain alike = chain, held = chain, loose = chain;
  std::ranges::fill(alike.k, chain.k.front());
  held.beyond = chain.k.back();
  loose.k.front() = 0;
  const double h = chain.h;
  struct Known {
    Chain matrix, right;
    double own;
    const char* says;
  };
  const Known known[] = {
      {alike, chain, 1, "in the matrix all springs are like the first"},
      {held, held, 1, "the last bead's row has a spring beyond it, too, and there is none"},
      {held, chain, 1, "in the matrix the last bead has a spring beyond it, and there is none"},
      {loose, loose, 1, "the spring to the wall is missing"},
      {loose, chain, 1, "in the matrix the spring to the wall is missing"},
      {chain, loose, 1, "on the right the spring to the wall is missing"},
      {chain, chain, 0, "on the diagonal the 1 is missing, which is the bead's own mass"},
      {times(1 / h), chain, 1, "the matrix has h k where h^2 k belongs"},
      {times(1 / (h * h)), chain, 1, "the matrix has k where h^2 k belongs"},
      {times(-1), chain, 1, "the matrix is 1 - h^2 K, where 1 + h^2 K belongs"},
      {chain, times(-1), 1, "on the right the springs push where they should pull"},
      {chain, times(1 / h), 1, "on the right a is not multiplied by h"},
      {chain, times(h), 1, "on the right a is multiplied by h twice"},
      {chain, times(0), 1, "on the right h a is missing"}};
  for (const auto& [matrix, right, own, says] : known)
    if (solves(end, matrix, right, within, own)) return says;
  return "";
}

// The bead whose row does not hold, if all others' do.
inline std::string left_out(const Chain& chain, const Beads& end, double within) {
  std::size_t missed = 0, last = 0;
  for (std::size_t i = 0; i < chain.count(); ++i) {
    if (row(end, chain, chain, i) <= within) continue;
    ++missed;
    last = i;
  }
  if (missed != 1 || chain.count() == 1) return "";
  return "all rows of the system hold but that of bead " + std::to_string(last) +
         ": does a loop leave it out?";
}

// The signs of an elimination: of what a row takes from the diagonal and from the right side of the
// next one, and of what goes back. 0 is for what is left out.
struct Signs {
  double diagonal = 1, right = 1, back = 1;
};

// Whether rows that are eliminated with these signs end there.
inline bool eliminates(const Chain& chain, const Beads& end, const Signs& signs, double within) {
  const double h = chain.h;
  const std::size_t count = chain.count();
  const auto beside = [&](std::size_t i) { return i < count ? h * h * chain.k[i] : 0; };
  Column middle(count), right(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = i > 0 ? beside(i) / middle[i - 1] : 0;
    middle[i] = 1 + beside(i) + beside(i + 1) - signs.diagonal * share * beside(i);
    right[i] = chain.start.v[i] + h * chain.acceleration(chain.start, i) +
               (i > 0 ? signs.right * share * right[i - 1] : 0);
  }
  for (std::size_t i = count; i-- > 0;) {
    const double next = i + 1 < count ? beside(i + 1) * end.v[i + 1] : 0;
    const double off = middle[i] * end.v[i] - right[i] - signs.back * next;
    if (!(std::abs(off) <= within)) return false;
  }
  return true;
}

inline std::string wrong_sign(const Chain& chain, const Beads& end, double within) {
  const std::pair<Signs, const char*> known[] = {
      {{1, 0, 1}, "the diagonal was eliminated, and the right side was not"},
      {{-1, 1, 1}, "in the elimination the diagonal grows, where something is taken from it"},
      {{1, -1, 1},
       "in the elimination the right side has the wrong sign: minus times minus is plus"},
      {{1, 1, -1},
       "on the way back the next velocity has the wrong sign: beside the diagonal is -h^2 k"},
      {{1, -1, -1}, "h^2 k stands beside the diagonal, where -h^2 k belongs"},
      {{0, 1, 1}, "the right side was eliminated, and the diagonal was not"},
      {{1, 1, 0}, "on the way back the next velocity is missing"},
      {{0, 0, 0}, "each bead's row has its diagonal alone: what its neighbours do is missing"}};
  for (const auto& [signs, says] : known)
    if (eliminates(chain, end, signs, within)) return says;
  return "";
}

// How far the worst line is met, where none is met and all are nearly.
inline std::string nearly_met(const Chain& chain, const Beads& end) {
  const double at_first = chain.miss(chain.start, worst(chain, chain.start));
  const double left = chain.miss(end, worst(chain, end)) / at_first;
  if (left > 1e-10 && left < 1e-5) return "right to some seven digits and no further: a float?";
  if (!(left > 1e-5 && left < 0.1)) return "";
  return "the worst line is missed by " + grade::number(100 * left, 2) +
         " % of what no step at all would miss: an iteration that was ended too soon?";
}

inline std::vector<std::string> recognised(const Chain& chain, const Beads& end, double within) {
  for (std::size_t i = 0; i < chain.count(); ++i)
    if (!std::isfinite(end.x[i]) || !std::isfinite(end.v[i]))
      return {"at bead " + std::to_string(i) + " this is not a finite number: a division by zero?"};
  bool still = true, borrowed = true, at_rest = true, moved = true;
  Beads change = end;
  for (std::size_t i = 0; i < chain.count(); ++i) change.x[i] = end.v[i] - chain.start.v[i];
  for (std::size_t i = 0; i < chain.count(); ++i) {
    const double kick = chain.h * chain.acceleration(chain.start, i);
    const double back = chain.h * chain.h * chain.acceleration(change, i);
    still = still && change.x[i] == 0;
    borrowed = borrowed && std::abs(change.x[i] - kick) <= within;
    at_rest = at_rest && std::abs(change.x[i] - kick - back) <= within;
    moved = moved && std::abs((end.x[i] - chain.start.x[i]) / chain.h - end.v[i]) <= within;
  }
  if (still) return {"no velocity changes"};
  if (borrowed) return {"the accelerations are those of the start: nothing is solved"};
  if (at_rest) return {"on the right of a system for the change belongs a(x + h v), not a(x)"};
  if (!moved) return {"the beads do not move with their new velocities"};
  const double rounded = 100 * within;
  for (const auto& recognise : {wrong_system, wrong_sign, left_out})
    if (const std::string says = recognise(chain, end, rounded); !says.empty()) return {says};
  const std::string nearly = nearly_met(chain, end);
  return {nearly.empty() ? who_misses(chain, end, within) : nearly};
}

}  // namespace judge::chain_of_beads
