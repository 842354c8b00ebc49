// SPDX-License-Identifier: MIT-0
/// @file
/// What a wrong step of the crate often is: each is put into the lines that it would meet.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "drag.h"
#include "judge/diagnose.h"

namespace judge::dragged_crate {

inline std::vector<std::string> first_of(const std::vector<std::pair<bool, const char*>>& remarks) {
  for (const auto& [holds, says] : remarks) {
    if (holds) return {says};
  }
  return {};
}

constexpr const char* measured_from_the_hand =
    "the place is measured from the hand: the hand's own place has to be added again";

inline double from_the_hand(const Drag& drag, const State& end) {
  return length(end.x + drag.hand - drag.start.x - drag.h * end.v) / drag.h;
}

/// A quotient with a slip: what stands above and below its line.
struct Quotient {
  Vec above;
  double below;
  const char* says;
};

/// Of a hand that is strong enough, and a crate that moves with its new velocity.
inline std::string wrong_quotient(const Drag& drag, const State& end, double within) {
  const auto [x, v] = drag.start;
  const double h = drag.h, omega = drag.omega, zeta = drag.zeta;
  const double stiff = h * omega * h * omega, damped = 2 * zeta * h * omega;
  const double below = drag.divisor();
  const Vec away = drag.hand - x, pull = h * omega * omega * away;
  const Quotient known[] = {
      {v - pull, below, "the spring pushes away from the hand: is it x - hand for hand - x?"},
      {v + pull, 1 + damped + h * omega * omega,
       "the divisor has h omega^2 where (h omega)^2 belongs"},
      {v + pull, 1 + damped,
       "the pull is the one at the old place: put the line of the position into it, and the "
       "divisor "
       "gets (h omega)^2"},
      {v + pull, damped + stiff, "the divisor has no 1, which comes from the new velocity itself"},
      {v + pull, 1 - damped + stiff, "the damping has the wrong sign in the divisor"},
      {v + pull, 1 + damped - stiff, "the pull has the wrong sign in the divisor"},
      {v + pull, 1 + 2 * zeta * omega + stiff, "the damping in the divisor is not multiplied by h"},
      {v + pull, 1 + 2 * zeta * h + stiff, "the damping in the divisor lacks omega"},
      {v + pull, 1, "nothing is divided by"},
      {v + pull / h, below, "above the divisor the pull is not multiplied by h"},
      {v + h * pull, below, "above the divisor the pull is multiplied by h twice"},
      {v + h * omega * away, below, "above the divisor omega is not squared"},
      {pull, below, "above the divisor the old velocity is missing"},
      {v + pull - damped * v, below,
       "the damping is there twice: above the divisor with the old velocity, and in it"}};
  for (const auto& [above, divisor, says] : known)
    if (length(end.v - above / divisor) <= within) return says;
  return "";
}

/// Of a hand that is strong enough.
inline std::vector<std::string> slips_of_strong(const Drag& drag, const State& end, double within) {
  const auto [x, v] = drag.start;
  const double h = drag.h;
  const Vec change = end.v - v, with_new = x + h * end.v;
  const Vec guessed = v + h * drag.acceleration(x, v);
  Drag at_zero = drag, soft = drag;
  at_zero.hand = {};
  soft.zeta /= 2;
  Drag undamped = drag;
  undamped.zeta = 0;
  const Vec right = v + drag.asked_for() / drag.divisor();
  const auto is = [&](double miss) { return miss <= within; };
  std::vector<std::string> found = first_of({
      {distance(end, drag.start) == 0, "the crate never moves"},
      {!is_finite(end), "this is not a finite number: a division by zero?"},
      {is(drag.miss(end, v, x, v)), "this is Euler's method"},
      {is(drag.miss(end, end.v, x, v)),
       "this is symplectic Euler: its acceleration is the one of the start"},
      {is(drag.miss(end, v, with_new, end.v)),
       "the velocity is right; the position moved with the old one"},
      {is(at_zero.miss(end)), "this is the step of a spring that pulls to zero"},
      {is(soft.miss(end)), "this is the step of a spring with half the damping"},
      {is(drag.miss(end, end.v, with_new, v)), "the damping is the one of the start"},
      {is(drag.miss(end, guessed, x + h * v, guessed)),
       "the end is guessed by a step of Euler's method, and not solved for"},
      {is(undamped.miss(end)), "the spring is right, and the damping is missing"},
      {like_a_float(length(end.v - right) / length(right)),
       "right to seven digits and no further: a float, or a constant with an f?"},
      {std::abs(length(change) - h * drag.strongest) <= within,
       "the change is as long as the hand allows, although the spring asks for less"},
      {is(from_the_hand(drag, end)), measured_from_the_hand},
      {is(length(end.v - right)), "the velocity is right, and the place is not x_old + h v"},
  });
  const std::string quotient = wrong_quotient(drag, end, within);
  if (found.empty() && !quotient.empty()) found = {quotient};
  return found;
}

/// Of a hand that is too weak.
inline std::vector<std::string> slips_of_weak(const Drag& drag, const State& end, double within) {
  const auto [x, v] = drag.start;
  const double most = drag.h * drag.strongest;
  const Vec change = end.v - v, asked = drag.asked_for() / drag.divisor(), away = drag.hand - x;
  const Vec each{std::clamp(asked.x, -most, most), std::clamp(asked.y, -most, most),
                 std::clamp(asked.z, -most, most)};
  const auto is = [&](double off) { return std::abs(off) <= within; };
  const auto points = [&](const Vec& along) {
    return most > 0 && is(length(change - most / length(along) * along));
  };
  return first_of({
      {distance(end, drag.start) == 0, "the crate never moves"},
      {!is_finite(end), "this is not a finite number: a division by zero?"},
      {is(drag.miss(end)),
       "this is what a strong hand does: there is no limit, or it is too high. Is it h times "
       "`strongest`?"},
      {most > within && is(length(change)),
       "the hand changes nothing, where it should change as much as it can"},
      {is(from_the_hand(drag, end)), measured_from_the_hand},
      {is(length(drag.divisor() * end.v - v - most / length(away) * away)),
       "the spring's pull is limited, and not the change of velocity that comes of it"},
      {is(length((end.x - x) / drag.h - v - asked)),
       "the crate moved with the velocity that a strong hand would have given it"},
      {is(length((end.x - x) / drag.h - v)), "the crate moved with the old velocity"},
      {most > 0 && is(length(change - each)),
       "each axis is limited by itself, which turns the change"},
      {most > 0 && is(length(change) - drag.strongest),
       "the change is as long as `strongest`, and not h times that"},
      {is(length(end.v) - most), "the velocity is limited, and not its change"},
      {most > 0 && is(drag.divisor() * length(change) - most),
       "the pull is limited before the division, which then takes its share of what is left"},
      {points(-1 * asked),
       "the change points the other way: is it the old velocity minus the new?"},
      {points(away), "the change points to the hand, and not where the spring's own change points"},
      {points(v + asked),
       "the change points along the velocity that a strong hand would give, and not along its "
       "change"},
      {most > 0 && is(length(change - drag.h * most / length(asked) * asked)),
       "the change is multiplied by h once too often"},
      {most > 0 && is(length(change) - most),
       "the change is as long as it should be, and points elsewhere: with a strong hand, is it "
       "right?"},
      {is(length(change - most / length(asked) * asked)),
       "the velocity is right, and the place is not x_old + h v"},
  });
}

inline std::vector<std::string> slips(const Drag& drag, const State& end, double within) {
  const bool strong = length(drag.asked_for()) < drag.divisor() * drag.h * drag.strongest;
  return strong ? slips_of_strong(drag, end, within) : slips_of_weak(drag, end, within);
}

}  // namespace judge::dragged_crate
