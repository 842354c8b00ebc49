// SPDX-License-Identifier: MIT-0
/// @file
/// A chain of beads, and the two lines of backward Euler for each.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "format_values.h"
#include "harness.h"
#include "judge/describe.h"
#include "judge/numbers.h"
#include "judge/random.h"
#include "judge/rounding.h"
#include "judge/student.h"

namespace judge::chain_of_beads {

using Column = std::vector<double>;

struct Beads {
  Column x, v;
};

/// A chain of beads of 1 kg.
struct Chain {
  Beads start;
  Column k;
  double h = 0;
  double beyond = 0;  ///< of a spring that holds the last bead from beyond; there is none

  /// A chain with springs of any stiffness beside the step: h^2 k up to `stiff`.
  static Chain draw(Random& random, std::size_t count, double stiff) {
    return draw(random, count, stiff, random.between(0.01, 0.04));
  }
  static Chain draw(Random& random, std::size_t count, double stiff, double h) {
    Chain chain;
    chain.h = h;
    for (std::size_t i = 0; i < count; ++i) {
      chain.start.x.push_back(random.between(-0.3, 0.3));
      chain.start.v.push_back(random.between(-1, 1));
      chain.k.push_back(random.between(0.1, 1) * stiff / (chain.h * chain.h));
    }
    return chain;
  }

  /// A chain of any beads and springs, soft ones beside hard ones, and some torn; one chain in four
  /// rests, and one in four is nowhere stretched.
  static Chain anywhere(Random& random, std::size_t count) {
    Chain chain;
    chain.h = random.anywhere(harness_bounds::h);
    const bool rests = random.whole(0, 3) == 0, slack = random.whole(0, 3) == 0;
    for (std::size_t i = 0; i < count; ++i) {
      chain.start.x.push_back(slack ? 0 : random.anywhere(harness_bounds::place));
      chain.start.v.push_back(rests ? 0 : random.anywhere(harness_bounds::velocity));
      chain.k.push_back(random.anywhere(harness_bounds::stiffness));
    }
    return chain;
  }

  std::size_t count() const { return k.size(); }

  Beads after_one(Student& student, const Beads& from) const {
    const Column end = student.call(0, as_numbers(count(), h, from.x, from.v, k), 2 * count());
    const auto middle = end.begin() + static_cast<std::ptrdiff_t>(count());
    return {{end.begin(), middle}, {middle, end.end()}};
  }

  double stretch(const Beads& beads, std::size_t i) const {
    return beads.x[i] - (i > 0 ? beads.x[i - 1] : 0);
  }

  double acceleration(const Beads& beads, std::size_t i) const {
    const double left = k[i] * stretch(beads, i);
    const double right = i + 1 < count() ? k[i + 1] * stretch(beads, i + 1) : -beyond * beads.x[i];
    return right - left;
  }

  double energy(const Beads& beads) const {
    double sum = 0;
    for (std::size_t i = 0; i < count(); ++i) {
      sum += (k[i] * stretch(beads, i) * stretch(beads, i) + beads.v[i] * beads.v[i]) / 2;
    }
    return sum;
  }

  /// The amount by which an end misses the two lines of backward Euler at a bead [m/s].
  double miss(const Beads& end, std::size_t i) const {
    const double moved = (end.x[i] - start.x[i]) / h - end.v[i];
    const double kicked = start.v[i] + h * acceleration(end, i) - end.v[i];
    return larger(std::abs(moved), std::abs(kicked));
  }

  /// The velocity that no bead exceeds, whatever was answered: all of the energy makes it.
  double fastest() const { return std::sqrt(2 * energy(start)); }

  /// The tolerance of an end: each of its numbers is a double, so that its lines cannot be met
  /// better than to the rounding of what they add up.
  Tolerance tolerance(const Beads& end) const { return tolerance(end, 0, count(), fastest()); }

  /// The tolerance of one bead's lines. In a matrix whose diagonal outweighs the rest an
  /// elimination leaves each row as wrong as its own numbers are rounded, and those of its
  /// neighbours.
  Tolerance tolerance(const Beads& end, std::size_t bead, double most) const {
    constexpr std::size_t near = 2;
    return tolerance(end, bead - std::min(bead, near), std::min(bead + near + 1, count()), most);
  }

  std::string described() const {
    std::string text = std::to_string(count()) + " beads, h = " + grade::number(h, 17);
    if (count() > 6) return text + ", and stiffnesses drawn from the seed";
    for (std::size_t i = 0; i < count(); ++i) {
      text +=
          "; bead " + std::to_string(i) + ": " + named("x", start.x[i], "v", start.v[i], "k", k[i]);
    }
    return text;
  }

 private:
  Tolerance tolerance(const Beads& end, std::size_t first, std::size_t behind, double most) const {
    const auto largest = [=](const Column& column) {
      double found = 0;
      for (std::size_t i = first; i < behind; ++i) found = std::max(found, std::abs(column[i]));
      return found;
    };
    const double velocity = std::min(largest(end.v), most);
    const double place = 2 * largest(start.x) + 2 * h * velocity;
    const double stiffest = largest(k);
    // A velocity's own rounding moves its bead, and that comes back as a force.
    const double again = 1 + h * h * stiffest;
    return rounding(again * (largest(start.v) + velocity + place / h + 4 * h * stiffest * place));
  }
};

}  // namespace judge::chain_of_beads
