// SPDX-License-Identifier: MIT-0
/// @file
/// A link with play, and what became of it.
#pragma once
#include <algorithm>
#include <string>
#include <utility>
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
  /// So long, and between these.
  static Link of_length(Random& random, double now, double shortest, double longest) {
    Link link = draw(random, 1, 1);
    link.b = link.a + now / link.length_now() * (link.b - link.a);
    link.shortest = shortest;
    link.longest = longest;
    return link;
  }
  /// Each bound and each special value once; and a rod, of which both bounds are one.
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
    const std::vector<Vec> ends = as_places(student.call(
        0, {a.x, a.y, a.z, b.x, b.y, b.z, shortest, longest, inverse_a, inverse_b}, 6));
    return {ends[0], ends[1], shortest, longest, inverse_a, inverse_b};
  }

  std::string in_words() const {
    const auto full = [](double value) { return grade::number(value, 17); };
    return "a = " + describe(a, 17) + ", b = " + describe(b, 17) + ", " +
           grade::number(length_now()) + " m apart, shortest = " + full(shortest) +
           ", longest = " + full(longest) + ", inverse_a = " + full(inverse_a) +
           ", inverse_b = " + full(inverse_b);
  }
};

/// A link that had play, and was moved.
inline std::string wrong_within_play(const Link& before, const Link& after) {
  const double off = length(after.a - before.a) + length(after.b - before.b);
  const auto is = [&](double bound) {
    return std::abs(after.length_now() - bound) <= before.tolerance();
  };
  if (off == 0) return "";
  if (off <= before.tolerance())
    return "it has play, and was moved by a rounding: leave it alone, without a sum";
  if (is(before.longest)) return "it has play, and was put to its longest all the same";
  if (is(before.shortest)) return "it has play, and was put to its shortest all the same";
  return "it has play, and was moved all the same";
}

/// A link that went some other part of the way to its bound than the whole.
inline std::string wrong_length(const Link& before, double part) {
  const double now = before.length_now(), bound = before.nearest(), way = now - bound;
  const double farther = bound == before.longest ? before.shortest : before.longest;
  const double weights = before.inverse_a + before.inverse_b;
  const double other = before.inverse_a * before.inverse_b / (weights * weights);
  // Jakobsen's root: one step of Newton's from the bound.
  const double root = now * (1 - 2 * bound * bound / (now * now + bound * bound)) / way;
  const std::pair<double, const char*> known[] = {
      {-1, "the ends went the wrong way"},
      {2, "each end went the whole way: the two shares should add up to one"},
      {0.5, "half of the way is missing"},
      {(now - farther) / way, "it was put to its other bound, which is farther off"},
      {(now - (bound + farther) / 2) / way, "it was put to the middle of its bounds"},
      {now, "the way times the length of the link: was the line divided by its length?"},
      {now / bound, "the way over the bound, and not over the length of now"},
      {root, "this is Jakobsen's root, which is only near when the stretch is small"},
      {weights, "each end moved by its own inverse mass: the two shares should add up to one"},
      {1 - other, "the second end was measured from where the first one is now, and not was"},
  };
  for (const auto& [factor, says] : known) {
    if (std::abs(part - factor) <= 1e-9 * (1 + std::abs(factor))) return says;
  }
  // A float counts beside the link, however short the way.
  const double off = std::abs(part - 1) * std::min(1.0, std::abs(way) / now);
  if (std::abs(part - 1) < 2e-6 || off < 1e-7)
    return "right to seven digits and no further: a float?";
  return "the ends came " + grade::number(part, 6) + " of the way to the bound";
}

/// A link that has the right length, and has it in another place than it should.
inline std::string wrong_place(const Link& before, const Vec& way_a, const Vec& way_b) {
  const auto none = [&](const Vec& way) { return length(way) <= before.tolerance(); };
  if (none(way_a + way_b)) return "half the way for each, whatever they weigh";
  if (none(before.inverse_a * way_a + before.inverse_b * way_b))
    return "the heavier end moved further: the shares are swapped";
  if (none(way_a) || none(way_b)) return "one end alone has moved, and none is pinned";
  const double share = length(way_a) / (length(way_a) + length(way_b));
  const double right = before.inverse_a / (before.inverse_a + before.inverse_b);
  if (std::abs(share - right) < 2e-7)
    return "the shares are right to seven digits and no further: a float?";
  if (std::abs(share - right) < 0.05 && std::abs(share - 0.5) < std::abs(right - 0.5))
    return "the shares are a little too alike: was something added to the inverse masses?";
  return "the common centre of mass has moved";
}

/// A pinned end that moved.
inline std::string wrong_pin(const Link& before, const Vec& way_a, const Vec& way_b) {
  const bool a_pinned = before.inverse_a == 0;
  const double pinned = length(a_pinned ? way_a : way_b), free = length(a_pinned ? way_b : way_a);
  if (free <= before.tolerance())
    return "the pinned end moved, and the other did not: are the shares swapped?";
  if (std::abs(pinned - free) <= before.tolerance())
    return "the pinned end moved, as far as the other: the inverse masses don't count";
  if (pinned < free / 20)
    return "the pinned end moved a little: was something added, so that nothing is divided by "
           "zero?";
  return "the pinned end moved";
}

/// What is looked at: whether the link has its length, on its line; or whose way was how long, too.
enum class Look { length, all };

/// The first thing that is wrong with a link after it was pulled; empty if nothing is.
inline std::string wrong_with(const Link& before, const Link& after, Look look = Look::all) {
  const Vec way_a = after.a - before.a, way_b = after.b - before.b, line = before.b - before.a;
  const double moved = length(way_a) + length(way_b), off = after.length_now() - before.nearest();
  const double weights = before.inverse_a + before.inverse_b;
  if (!std::isfinite(moved))
    return weights > 0 ? "an end is no longer at a finite place"
                       : "with both ends pinned the shares are 0 / 0, which is no number";
  if (before.has_play()) return wrong_within_play(before, after);
  if (weights == 0) return moved > 0 ? "both ends are pinned, and one moved" : "";
  if (moved == 0)
    return before.length_now() < before.shortest
               ? "nothing moved: a link that is too short wants to be pushed apart"
               : "nothing moved: a link that is too long wants to be drawn together";
  const bool pin_gave_way = (before.inverse_a == 0 && length(way_a) > before.tolerance()) ||
                            (before.inverse_b == 0 && length(way_b) > before.tolerance());
  if (pin_gave_way && look == Look::all) return wrong_pin(before, way_a, way_b);
  const auto sideways = [&](const Vec& way) {
    return length(way - dot(way, line) / dot(line, line) * line) > before.tolerance();
  };
  if (sideways(way_a) || sideways(way_b)) return "an end has left the line of the link";
  // Along the line: an end that went past the other has a length below zero.
  const double now = before.length_now(), come = dot(way_a - way_b, line) / now;
  if (std::abs(off) > before.tolerance() || come > now)
    return wrong_length(before, come / (now - before.nearest()));
  if (look == Look::length) return "";
  const Vec pushed = before.inverse_b * way_a + before.inverse_a * way_b;
  return length(pushed) <= before.tolerance() * weights ? "" : wrong_place(before, way_a, way_b);
}

/// What there is to say of one pull.
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
