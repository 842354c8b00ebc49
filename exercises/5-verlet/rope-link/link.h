// SPDX-License-Identifier: MIT-0
/// @file
/// A link that is too long or too short, and a chain of them.
#pragma once
#include "../places.h"
#include "judge/random.h"

namespace judge::verlet {

struct Link {
  Vec a, b;
  double rest = 0;
  double inverse_a = 0, inverse_b = 0;

  /// Its ends have different masses; it is so much too long, or too short, that it shows.
  static Link draw(Random& random, bool too_long) {
    Link link{random.start().x, {}, 0, random.between(0.2, 0.8), random.between(1.2, 5)};
    if (random.whole(0, 1) == 1) std::swap(link.inverse_a, link.inverse_b);
    link.b = link.a + random.vector(0.4, 1.5);
    const double share = too_long ? random.between(0.4, 0.8) : random.between(1.3, 2.5);
    link.rest = share * length(link.b - link.a);
    return link;
  }

  std::vector<Vec> by(Student& student) const {
    return as_places(
        student.call(0, {a.x, a.y, a.z, b.x, b.y, b.z, rest, inverse_a, inverse_b}, 6));
  }

  /// The ends, if a goes so many excesses towards b, and b so many towards a.
  std::vector<Vec> moved(double share_a, double share_b) const {
    const Vec d = b - a;
    const Vec excess = (length(d) - rest) / length(d) * d;
    return {a + share_a * excess, b - share_b * excess};
  }

  double share_a() const { return inverse_a / (inverse_a + inverse_b); }

  std::vector<Vec> pulled() const { return moved(share_a(), 1 - share_a()); }

  std::string in_words() const {
    return "a = " + describe(a, 17) + ", b = " + describe(b, 17) +
           ", rest = " + grade::number(rest, 17) + ", inverse_a = " + grade::number(inverse_a, 17) +
           ", inverse_b = " + grade::number(inverse_b, 17);
  }

  /// What people make of it.
  std::vector<Places> mistakes() const {
    const double d = length(b - a), share = share_a();
    const auto times = [&](double factor) { return moved(factor * share, factor * (1 - share)); };
    // Jakobsen's root: one step of Newton's from the rest length.
    const double jakobsen = (0.5 - rest * rest / (d * d + rest * rest)) * 2 * d / (d - rest);
    return {
        {"a link that nothing moved", {a, b}},
        {"half the way for each, whatever they weigh", moved(0.5, 0.5)},
        {"the heavier end moves further: the shares are swapped", moved(1 - share, share)},
        {"the ends moved apart instead of together, or together instead of apart", times(-1)},
        {"the whole way for both ends: it ends as wrong as it began", moved(1, 1)},
        {"half of the way that is missing", times(0.5)},
        {"the way times the length of the link: was d divided by its length?", times(d)},
        {"the way over the rest length, not over the length of now", times(d / rest)},
        {"Jakobsen's root, which is only near when the stretch is small", times(jakobsen)},
        {"each end moved by its own inverse mass: the two shares should add up to one",
         moved(inverse_a, inverse_b)},
    };
  }
};

}  // namespace judge::verlet
