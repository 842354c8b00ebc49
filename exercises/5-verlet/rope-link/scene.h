// SPDX-License-Identifier: MIT-0
/// @file
/// A link with play, and what became of it.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "../places.h"
#include "harness.h"
#include "judge/random.h"

namespace judge::verlet::rope_link {

struct Link {
  Vec a, b;
  double shortest = 0, longest = 0;
  double inverse_a = 0, inverse_b = 0;

  /// Its ends have different masses.
  /// @param low, high  its bounds, as parts of how long it is
  static Link draw(Random& random, double low, double high) {
    Link link{random.start().x, {}, 0, 0, random.between(0.2, 0.8), random.between(1.2, 5)};
    if (random.whole(0, 1) == 1) std::swap(link.inverse_a, link.inverse_b);
    link.b = link.a + random.vector(0.4, 1.5);
    link.shortest = low * link.length_now();
    link.longest = high * link.length_now();
    return link;
  }
  /// A link so long, and between these.
  static Link of_length(Random& random, double now, double shortest, double longest) {
    Link link = draw(random, 1, 1);
    link.b = link.a + now / link.length_now() * (link.b - link.a);
    link.shortest = shortest;
    link.longest = longest;
    return link;
  }
  /// Any link that may be asked: any lengths and masses, along an axis too; now and then as far
  /// apart as may be, or nearly as long as a bound.
  static Link anywhere(Random& random) {
    Link link;
    link.a = random.vector_anywhere(harness_bounds::place);
    link.b = -link.a;
    if (random.whole(0, 4) > 0 || link.length_now() == 0) {
      if (random.whole(0, 2) == 0) link.a = {};
      do {
        link.b = link.a + random.vector_anywhere(harness_bounds::place);
      } while (link.length_now() == 0);
    }
    link.longest = random.anywhere(harness_bounds::longest);
    link.shortest = std::min(link.longest, random.anywhere(harness_bounds::shortest));
    const double near = link.length_now() * random.nearly_one(1e-12, 0.1);
    const int bound = random.whole(0, 5);
    if (bound == 0 && near > harness_bounds::longest.smallest()) link.longest = near;
    if (bound == 1) link.shortest = near;
    link.longest =
        std::min(std::max(link.longest, link.shortest), harness_bounds::longest.largest());
    link.shortest = std::min(link.shortest, link.longest);
    link.inverse_a = random.anywhere(harness_bounds::inverse);
    link.inverse_b = random.anywhere(harness_bounds::inverse);
    return link;
  }
  /// Links at each bound and each special value; and a rod, of which both bounds are one.
  static std::vector<Link> at_the_bounds(Random& random) {
    std::vector<Link> links;
    const double now = random.between(1, 2);
    for (const double other : {now / 2, 2 * now})
      links.push_back(of_length(random, now, other, other));
    for (const double longest : harness_bounds::longest.asked())
      links.push_back(
          of_length(random, now * longest, harness_bounds::shortest.smallest(), longest));
    const double most = harness_bounds::shortest.largest();
    links.push_back(of_length(random, most / now / 2, most, most));
    return links;
  }

  static Link too_long(Random& random) {
    const double longest = random.between(0.4, 0.8);
    return draw(random, longest * random.between(0.3, 0.8), longest);
  }
  static Link too_short(Random& random) {
    const double shortest = random.between(1.3, 2.5);
    return draw(random, shortest, shortest * random.between(1.2, 2));
  }

  double length_now() const { return length(b - a); }
  double nearest() const { return std::clamp(length_now(), shortest, longest); }
  bool has_play() const { return nearest() == length_now(); }
  double tolerance() const { return rounding(length(a) + length(b) + longest).value; }

  Link after(Student& student) const {
    const auto numbers = as_numbers(a, b, shortest, longest, inverse_a, inverse_b);
    const std::vector<Vec> ends = as_vectors(student.call(0, numbers, 6));
    return {ends[0], ends[1], shortest, longest, inverse_a, inverse_b};
  }

  std::string in_words() const {
    return named("a", a, "b", b) + ", " + grade::number(length_now()) + " m apart, " +
           named("shortest", shortest, "longest", longest, "inverse_a", inverse_a, "inverse_b",
                 inverse_b);
  }
};

/// The part of a link that is judged: whether the link has its length, on its line; or whose way
/// was how long, too.
enum class Look { length, all };

/// The first thing that is wrong with a link after it was pulled; empty if nothing is.
inline std::string wrong_with(const Link& before, const Link& after, Look look = Look::all) {
  const Vec way_a = after.a - before.a, way_b = after.b - before.b, line = before.b - before.a;
  const double moved = length(way_a) + length(way_b), off = after.length_now() - before.nearest();
  const double weights = before.inverse_a + before.inverse_b;
  if (!std::isfinite(moved))
    return weights > 0 ? "an end is no longer at a finite place"
                       : "with both ends pinned the shares are 0 / 0, which is no number";
  if (before.has_play()) return moved > 0 ? "it has play, and was moved all the same" : "";
  if (weights == 0) return moved > 0 ? "both ends are pinned, and one moved" : "";
  if (moved == 0 && std::abs(off) <= before.tolerance()) return "";
  if (moved == 0)
    return before.length_now() < before.shortest
               ? "nothing moved: a link that is too short wants to be pushed apart"
               : "nothing moved: a link that is too long wants to be drawn together";
  const bool pin_gave_way = (before.inverse_a == 0 && length(way_a) > before.tolerance()) ||
                            (before.inverse_b == 0 && length(way_b) > before.tolerance());
  if (pin_gave_way && look == Look::all) return "the pinned end moved";
  const auto sideways = [&](const Vec& way) {
    return length(way - dot(way, line) / dot(line, line) * line) > before.tolerance();
  };
  if (sideways(way_a) || sideways(way_b)) return "an end has left the line of the link";
  // Along the line: an end that went past the other has a length below zero.
  const double now = before.length_now(), come = dot(way_a - way_b, line) / now;
  if (std::abs(off) > before.tolerance() || come > now)
    return "the ends came " + grade::number(come / (now - before.nearest()), 6) +
           " of the way to the bound";
  if (look == Look::length) return "";
  const Vec pushed = before.inverse_b * way_a + before.inverse_a * way_b;
  return length(pushed) <= before.tolerance() * weights ? ""
                                                        : "the common centre of mass has moved";
}

/// The finding on one pull.
inline grade::Finding pulled(const Link& before, const Link& after, const std::string& what,
                             Look look) {
  const std::string wrong = wrong_with(before, after, look);
  const bool stays = before.has_play() || before.inverse_a + before.inverse_b == 0;
  grade::Finding finding;
  finding.held = wrong.empty();
  finding.asked = what;
  finding.input = before.in_words();
  finding.expected = stays ? "both ends where they were"
                           : "a length of " + grade::number(before.nearest(), 12) +
                                 " m, along the line of the link" +
                                 (look == Look::all ? ", and its centre of mass where it was" : "");
  finding.got = "a = " + describe(after.a, 12) + ", b = " + describe(after.b, 12) + ", " +
                grade::number(after.length_now(), 12) + " m apart";
  finding.error =
      "a went " + describe(after.a - before.a, 3) + ", b went " + describe(after.b - before.b, 3);
  finding.tolerance = grade::number(stays ? 0 : before.tolerance(), 2);
  finding.tolerance_from = stays ? "nothing should be touched" : rounding(1).from;
  if (!finding.held) finding.diagnoses = {wrong};
  return finding;
}

}  // namespace judge::verlet::rope_link
