// SPDX-License-Identifier: MIT-0
// What the methods with memory begin with and what they are read by, at a time that is not zero;
// position Verlet with steps that change; the error estimate of Dormand and Prince.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <limits>

#include "integrate/dopri5.h"
#include "integrate/leapfrog.h"
#include "integrate/stormer_verlet.h"
#include "integrate/velocity_verlet.h"
#include "integrate/yoshida4.h"
#include "textbook/runge_kutta.h"

using Catch::Matchers::WithinAbs;

namespace {

const textbook::Pushed pushed;

// A start in the middle of the motion.
template <class Real>
struct Start {
  Real x = Real(0.7), v = Real(-1.1), t = Real(2.3);
  Real h = Real(0.3);
  long double a = pushed((long double)x, (long double)v, (long double)t);
};

// Fewer than 32 roundings, each by half an epsilon of a number below 4.
template <class Real>
const double rounding = 64 * double(std::numeric_limits<Real>::epsilon());

template <class Real>
auto is(long double expected) {
  return WithinAbs(double(expected), rounding<Real>);
}

}  // namespace

TEMPLATE_TEST_CASE("Position Verlet starts from where a constant acceleration comes from", "",
                   double, float) {
  const Start<TestType> s;
  for (const TestType h : {s.h, -s.h}) {
    const TestType before = integrate::stormer_verlet_start(s.x, s.v, s.t, h, pushed);
    const long double slower = s.v - h * s.a;
    CHECK_THAT(before + h * (slower + s.v) / 2, is<TestType>(s.x));
  }
}

TEMPLATE_TEST_CASE("The velocity of position Verlet is the distance over the time, and half a kick",
                   "", double, float) {
  const Start<TestType> s;
  const TestType before = TestType(0.98), a = TestType(-3.7);
  for (const TestType h : {s.h, -s.h}) {
    CHECK_THAT(h * integrate::stormer_verlet_velocity(s.x, before, h), is<TestType>(s.x - before));
    CHECK_THAT(h * integrate::stormer_verlet_carried_velocity(s.x, before, a, h),
               is<TestType>(s.x - before + h * h * a / 2));
  }
}

TEMPLATE_TEST_CASE("Leapfrog starts half a kick ago and is read half a kick later", "", double,
                   float) {
  const Start<TestType> s;
  for (const TestType h : {s.h, -s.h}) {
    const TestType half = integrate::leapfrog_start(s.x, s.v, s.t, h, pushed);
    CHECK_THAT(2 * (s.v - half), is<TestType>(h * s.a));
    const TestType v = integrate::leapfrog_velocity(s.x, s.v, s.t, h, pushed);
    CHECK_THAT(2 * (v - s.v), is<TestType>(h * s.a));
  }
}

TEMPLATE_TEST_CASE("The methods that carry the acceleration start with the one of now", "", double,
                   float) {
  const Start<TestType> s;
  CHECK_THAT(integrate::velocity_verlet_start(s.x, s.v, s.t, pushed), is<TestType>(s.a));
  CHECK_THAT(integrate::yoshida4_start(s.x, s.v, s.t, pushed), is<TestType>(s.a));
  CHECK_THAT(integrate::dopri5_start(s.x, s.v, s.t, pushed), is<TestType>(s.a));
}

// The second divided difference of the positions, times 2, is the acceleration in the middle.
TEMPLATE_TEST_CASE("With steps that change, position Verlet has the mean of both as its kick", "",
                   double, float) {
  const Start<TestType> s;
  TestType x = s.x, t = s.t, h_previous = s.h;
  TestType x_previous = integrate::stormer_verlet_start(x, s.v, t, h_previous, pushed);
  long double at = x, speed = s.v - s.h * s.a / 2;
  for (const TestType h : {TestType(0.1), TestType(0.4), TestType(0.25), TestType(0.25)}) {
    integrate::stormer_verlet_uneven(x, x_previous, t, h, h_previous, pushed);
    speed += (h_previous + h) / 2 * pushed(at, speed, (long double)t);
    CHECK_THAT(x_previous, is<TestType>(at));
    at += h * speed;
    CHECK_THAT(x, is<TestType>(at));
    t += h;
    h_previous = h;
  }
}

TEMPLATE_TEST_CASE("Dormand and Prince's estimate is the step of order 5 less that of order 4", "",
                   double, float) {
  const Start<TestType> s;
  for (const TestType h : {3 * s.h, -3 * s.h}) {
    TestType x = s.x, v = s.v, a = TestType(s.a);
    const auto error = integrate::dopri5(x, v, a, s.t, h, pushed);
    const auto table = textbook::table(measure::Dopri5());
    const auto slopes = textbook::stages(table, pushed, {s.x, s.v}, s.t, h);
    textbook::Row apart = textbook::dopri4;
    for (std::size_t i = 0; i < apart.size(); ++i) {
      apart[i] = (i < table.b.size() ? table.b[i] : 0) - apart[i];
    }
    const textbook::Pair expected = h * textbook::sum(apart, slopes);
    CHECK_THAT(error.x, is<TestType>(expected[0]));
    CHECK_THAT(error.v, is<TestType>(expected[1]));
    CHECK_THAT(a, is<TestType>(slopes[6][1]));
    CHECK(expected.cwiseAbs().minCoeff() > 16 * rounding<TestType>);
  }
}
