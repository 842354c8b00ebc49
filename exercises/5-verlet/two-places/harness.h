// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds h{"h", 0.001, 1}, floor{"floor", -100, 100, 0},
    restitution{"restitution", 0, 1}, place{"x", 0, 1000}, velocity{"v", 0, 100}, a{"a", 0, 1000};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<Vec(const Vec& x, const Vec& x_previous, const Vec& a, double h)> wanted =
    next_place;
const harness::Within within_wanted{
    wanted, {harness_bounds::place, harness::any, harness_bounds::a, harness_bounds::h}};

const harness::Wanted<Vec(const Vec& x, const Vec& v, const Vec& a, double h)> wanted_before =
    place_before;
const harness::Within within_before{
    wanted_before,
    {harness_bounds::place, harness_bounds::velocity, harness_bounds::a, harness_bounds::h}};

const harness::Wanted<void(Vec& x, Vec& x_previous, double floor, double restitution)>
    wanted_bounce = bounce;
const harness::Within within_bounce{
    wanted_bounce,
    {harness::any, harness::any, harness_bounds::floor, harness_bounds::restitution}};

// The velocity that drag sees is the last distance over its time.
inline void take_steps(harness::Call& call) {
  const harness::Run run(call);
  Vec x = run.x, v = run.v;
  Vec x_previous = wanted_before(x, v, run.acceleration(x, v, run.t), run.h);
  for (int n = 0; n < run.steps; ++n) {
    v = (x - x_previous) / run.h;
    const Vec next = wanted(x, x_previous, run.acceleration(x, v, run.t + n * run.h), run.h);
    x_previous = x;
    x = next;
    if ((n + 1) % run.every != 0) continue;
    call.answer(x);
    call.answer((x - x_previous) / run.h);
  }
}

inline void let_bounce(harness::Call& call) {
  Vec x = call.vector(), x_previous = call.vector();
  const double floor = call.number(), restitution = call.number();
  wanted_bounce(x, x_previous, floor, restitution);
  call.answer(x);
  call.answer(x_previous);
}

// Its height above the floor, after each step.
inline void let_fall(harness::Call& call) {
  constexpr double floor = 0.25;
  Vec x{0, floor + call.number(), 0};
  const double restitution = call.number();
  const Vec a{0, -call.number(), 0};
  const double h = call.number();
  Vec x_previous = wanted_before(x, {0.5, 0, 0.25}, a, h);
  for (int steps = call.whole_number(); steps > 0; --steps) {
    const Vec next = wanted(x, x_previous, a, h);
    x_previous = x;
    x = next;
    wanted_bounce(x, x_previous, floor, restitution);
    call.answer(x.y - floor);
  }
}

void answer(harness::Call& call) {
  if (call.function() == 0) return take_steps(call);
  if (call.function() == 3) return let_bounce(call);
  if (call.function() == 4) return let_fall(call);
  const Vec x = call.vector(), other = call.vector(), a = call.vector();
  call.answer((call.function() == 1 ? wanted : wanted_before)(x, other, a, call.number()));
}

#endif
