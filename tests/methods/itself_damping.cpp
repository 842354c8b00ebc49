// SPDX-License-Identifier: MIT-0
// Each way to damp linearly: the velocity at the end of a step, from the equation that it solves.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <limits>
#include <vector>

#include "integrate/linear_damping.h"
#include "textbook/exponential.h"

using Catch::Matchers::WithinAbs;

namespace {

using textbook::Matrix;
using textbook::Real;

// What there is before the damping: the velocity v, the kick h a, and c h.
struct Kick {
  Real v, kick, damping;
};

// A damping and a constant push, as the equation y' = -c y + push for a step of length 1.
Matrix flow(Real damping) {
  Matrix equation;
  equation << -damping, 1, 0, 0;
  return textbook::exponential(equation);
}

// The explicit ways take c h of the velocity away, but not more than there is.
Real less(Real velocity, Real damping) {
  return damping > 1 ? 0 : velocity - damping * velocity;
}

// Rounding: the sums round fewer than 16 times by half an epsilon; the numbers stay below 4, but
// for what a negative step brings back, divided by 1 + c h, above 1/16.
template <class Vec>
const double rounding = 16 * double(std::numeric_limits<Vec>::epsilon()) / 2 * 4 * 16;

template <class Vec, class Step, class Velocity>
void check_steps(Step step, Velocity velocity) {
  for (const Vec h : {Vec(0.3), Vec(-0.18)}) {
    for (const Vec c : {Vec(0), Vec(0.7), Vec(5)}) {
      for (const Vec t : {Vec(0), Vec(0.6), Vec(2.3)}) {
        CAPTURE(h, c, t);
        Vec x = Vec(0.7), v = Vec(-1.1);
        const Real at = x, speed = v;
        const Kick kick{speed, Real(h) * textbook::Pushed()(at, speed, Real(t)), Real(c) * h};
        std::vector<Real> asked;
        step(x, v, t, h, c, [&asked](Vec x_now, Vec v_now, Vec now) {
          asked.insert(asked.end(), {x_now, v_now, now});
          return textbook::Pushed()(x_now, v_now, now);
        });
        CHECK(asked == std::vector<Real>{at, speed, t});
        CHECK_THAT(v, WithinAbs(double(velocity(kick)), rounding<Vec>));
        CHECK_THAT(x, WithinAbs(double(at + Real(h) * v), rounding<Vec>));
      }
    }
  }
}

}  // namespace

TEMPLATE_TEST_CASE(
    "Each way to damp asks for one acceleration, at the start, and solves its equation", "", double,
    float) {
  SECTION("explicit, last") {
    check_steps<TestType>([](auto&&... p) { integrate::linear_damping_explicit_last(p...); },
                          [](Kick k) { return less(k.v + k.kick, k.damping); });
  }
  SECTION("explicit, first") {
    check_steps<TestType>([](auto&&... p) { integrate::linear_damping_explicit_first(p...); },
                          [](Kick k) { return less(k.v, k.damping) + k.kick; });
  }
  SECTION("implicit, last") {
    check_steps<TestType>([](auto&&... p) { integrate::linear_damping_implicit_last(p...); },
                          [](Kick k) { return (k.v + k.kick) / (1 + k.damping); });
  }
  SECTION("implicit, first") {
    check_steps<TestType>([](auto&&... p) { integrate::linear_damping_implicit_first(p...); },
                          [](Kick k) { return k.v / (1 + k.damping) + k.kick; });
  }
  SECTION("exponential, last") {
    check_steps<TestType>([](auto&&... p) { integrate::linear_damping_exponential_last(p...); },
                          [](Kick k) { return flow(k.damping)(0, 0) * (k.v + k.kick); });
  }
  SECTION("exponential, first") {
    check_steps<TestType>([](auto&&... p) { integrate::linear_damping_exponential_first(p...); },
                          [](Kick k) { return flow(k.damping)(0, 0) * k.v + k.kick; });
  }
  SECTION("exact") {
    check_steps<TestType>(
        [](auto&&... p) { integrate::linear_damping_exact(p...); },
        [](Kick k) { return (flow(k.damping) * textbook::Pair(k.v, k.kick))[0]; });
  }
}
