// SPDX-License-Identifier: MIT-0
// What gives away the method of an engine from outside: ten steps of free fall, and the speed at
// which a fall with damping ends.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <typeinfo>

#include "measure/methods.h"
#include "measure/run.h"
#include "scenes/linear_drag.h"
#include "theory_of_damping.h"

using Catch::Matchers::WithinRel;
using scenes::LinearDrag;

namespace {

// y / (g h^2) after ten steps from rest.
template <class Step>
double fingerprint(const Step& step, double h) {
  const LinearDrag<> fall{.c = 0};
  return -measure::after(step, fall, fall.start(), h, 10).x / (fall.g * h * h);
}

template <class Method>
void check_fingerprint(double wanted) {
  INFO(typeid(Method).name());
  for (const double h : {1.0 / 60, 1.0 / 20}) {
    CHECK_THAT(fingerprint(Method(), h), WithinRel(wanted, 1e-13));
  }
}

// The speeds of the steps that each moves with, in g h, are 0 to 9, 1/2 to 9 1/2, or 1 to 10.
template <auto Depth>
using Falling = list::Where<[](auto method) { return method.free_fall_after_ten_steps == Depth; }>;
// Of BDF2's start, whose first step moves with a third of the velocity of its start and two thirds
// of that of its end.
using FallingByStart = Falling<measure::KeepsLastState::free_fall_after_ten_steps>;
static_assert(std::tuple_size_v<Falling<45>> + std::tuple_size_v<Falling<50>> +
                      std::tuple_size_v<Falling<55>> + std::tuple_size_v<FallingByStart> >=
                  std::tuple_size_v<list::General>,
              "tests/methods/engines.cpp: a method whose `free_fall_after_ten_steps` is none of "
              "45, 50 and 55");

// The speed at which a fall ends.
template <class Step>
double terminal_speed(const Step& step, double g, double c, double h) {
  const LinearDrag<> fall{.c = c, .g = g};
  return -measure::after(step, fall, fall.start(), h, std::lround(100 / (c * h))).v;
}

// Against a closed form of c h, in terms of the true g / c.
template <class Step, class Form>
void check_terminal_speed(const Step& step, Form closed_form) {
  const double g = 9.81, c = 2;
  for (const double h : {1.0 / 60, 1.0 / 20}) {
    CAPTURE(h);
    CHECK_THAT(terminal_speed(step, g, c, h), WithinRel(closed_form(c * h) * g / c, 1e-13));
  }
}

double one(double) {
  return 1;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("Ten steps of free fall with the velocity before give 45 g h^2", "",
                        Falling<45>) {
  check_fingerprint<TestType>(45);
}

TEMPLATE_LIST_TEST_CASE("Ten steps of free fall with the velocity between give the true 50 g h^2",
                        "", Falling<50>) {
  check_fingerprint<TestType>(50);
}

TEMPLATE_LIST_TEST_CASE("Ten steps of free fall with the velocity after give 55 g h^2", "",
                        Falling<55>) {
  check_fingerprint<TestType>(55);
}

TEMPLATE_LIST_TEST_CASE("Ten steps of free fall by BDF2 give its start's quarter more than 50", "",
                        FallingByStart) {
  // A sixth of the first step, and a third of what is left of it in each step after that.
  double more = 0;
  for (int n = 0; n < 10; ++n) more += std::pow(3, -n) / 6;
  check_fingerprint<TestType>(50 + more);
}

TEST_CASE("Position Verlet that begins with x_previous = x falls like symplectic Euler") {
  const auto gravity = [](double, double, double) { return -9.81; };
  const double h = 1.0 / 60;
  double x = 0, x_previous = 0;
  for (int n = 0; n < 10; ++n) integrate::stormer_verlet(x, x_previous, n * h, h, gravity);
  CHECK_THAT(-x / (9.81 * h * h), WithinRel(55.0, 1e-13));
}

TEST_CASE("Four substeps of symplectic Euler bring 55 down to 51.25") {
  const LinearDrag<> fall{.c = 0};
  const double h = 1.0 / 60;
  const auto end = measure::after(measure::symplectic_euler, fall, fall.start(), h / 4, 40);
  CHECK_THAT(-end.x / (fall.g * h * h), WithinRel(51.25, 1e-13));
}

TEMPLATE_LIST_TEST_CASE("The terminal speed is the one that a step of its damping leaves alone", "",
                        list::Damping) {
  INFO(typeid(TestType).name());
  check_terminal_speed(TestType(), [](double ch) {
    const auto [keep, push] = theory::damped(TestType(), ch);
    return ch * push / (1 - keep);  // of v = keep v + push g h
  });
}

TEST_CASE("With 1 - c h after the force the terminal speed is 1 - c h of the true one") {
  check_terminal_speed(measure::linear_damping_explicit_last, [](double ch) { return 1 - ch; });
}

TEST_CASE("With 1 - c h before the force, or 1 + c h under both, the terminal speed is true") {
  check_terminal_speed(measure::linear_damping_explicit_first, one);
  check_terminal_speed(measure::linear_damping_implicit_last, one);
}

TEST_CASE("With 1 + c h under the old speed alone the terminal speed is 1 + c h of the true one") {
  check_terminal_speed(measure::linear_damping_implicit_first, [](double ch) { return 1 + ch; });
}

TEST_CASE("With exp(-c h) the terminal speed is too small after the force, too large before it") {
  check_terminal_speed(measure::linear_damping_exponential_last,
                       [](double ch) { return ch / std::expm1(ch); });
  check_terminal_speed(measure::linear_damping_exponential_first,
                       [](double ch) { return -ch / std::expm1(-ch); });
}

TEST_CASE("With the exact velocity the terminal speed is true") {
  check_terminal_speed(measure::linear_damping_exact, one);
}
