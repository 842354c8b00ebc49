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

namespace judge {

inline std::vector<std::string> first_of(const std::vector<std::pair<bool, const char*>>& remarks) {
  for (const auto& [holds, says] : remarks) {
    if (holds) return {says};
  }
  return {};
}

/// Of a hand that is strong enough.
inline std::vector<std::string> slips_of_strong(const Drag& drag, const State& end, double within) {
  const auto [x, v] = drag.start;
  const double h = drag.h, pull = h * drag.omega * drag.omega;
  const Vec change = end.v - v, with_new = x + h * end.v;
  const Vec guessed = v + h * drag.acceleration(x, v);
  Drag at_zero = drag, soft = drag;
  at_zero.hand = {};
  soft.zeta /= 2;
  Drag undamped = drag;
  undamped.zeta = 0;
  const Vec right = v + drag.asked_for() / drag.divisor();
  const double over = 1 + 2 * drag.zeta * h * drag.omega + pull;
  const Vec unsquared = over * end.v - v - pull * (drag.hand - x);
  const Vec pushed = drag.divisor() * end.v - v + pull * (drag.hand - x);
  const auto is = [&](double miss) { return miss <= within; };
  return first_of({
      {distance(end, drag.start) == 0, "the crate never moves"},
      {!is_finite(end), "this is not a finite number: a division by zero?"},
      {is(drag.miss(end, v, x, v)), "this is Euler's method"},
      {is(drag.miss(end, end.v, x, v)),
       "this is symplectic Euler: its acceleration is the one of the start"},
      {is(drag.miss(end, v, with_new, end.v)),
       "the velocity is right; the position moved with the old one"},
      {is(at_zero.miss(end)), "this is the step of a spring that pulls to zero"},
      {is(length(pushed)), "the spring pushes away from the hand: is it x - hand for hand - x?"},
      {is(soft.miss(end)), "this is the step of a spring with half the damping"},
      {is(drag.miss(end, end.v, with_new, v)), "the damping is the one of the start"},
      {is(drag.miss(end, guessed, x + h * v, guessed)),
       "the end is guessed by a step of Euler's method, and not solved for"},
      {is(undamped.miss(end)), "the spring is right, and the damping is missing"},
      {length(end.v - right) > within && length(end.v - right) < 2e-6 * length(right),
       "right to seven digits and no further: a float, or a constant with an f?"},
      {is(length(unsquared)), "the divisor has h omega^2 where (h omega)^2 belongs"},
      {std::abs(length(change) - h * drag.strongest) <= within,
       "the change is as long as the hand allows, although the spring asks for less"},
  });
}

/// Of a hand that is too weak.
inline std::vector<std::string> slips_of_weak(const Drag& drag, const State& end, double within) {
  const auto [x, v] = drag.start;
  const double most = drag.h * drag.strongest;
  const Vec change = end.v - v, asked = drag.asked_for() / drag.divisor();
  const Vec each{std::clamp(asked.x, -most, most), std::clamp(asked.y, -most, most),
                 std::clamp(asked.z, -most, most)};
  const auto is = [&](double off) { return std::abs(off) <= within; };
  return first_of({
      {distance(end, drag.start) == 0, "the crate never moves"},
      {!is_finite(end), "this is not a finite number: a division by zero?"},
      {is(drag.miss(end)),
       "this is what a strong hand does: there is no limit, or it is too high. Is it h times "
       "`strongest`?"},
      {most > within && is(length(change)),
       "the hand changes nothing, where it should change as much as it can"},
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
  });
}

inline std::vector<std::string> slips(const Drag& drag, const State& end, double within) {
  const bool strong = length(drag.asked_for()) < drag.divisor() * drag.h * drag.strongest;
  return strong ? slips_of_strong(drag, end, within) : slips_of_weak(drag, end, within);
}

}  // namespace judge
