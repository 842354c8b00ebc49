// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds h1{"h1", 1e-3, 1}, error1{"error1", 1e-9, 100}, h2{"h2", 1e-4, 0.5},
    error2{"error2", 1e-13, 10};
constexpr harness::Bounds wanted{"wanted", 1e-13, 10}, h{"h", 1e-4, 1}, error{"error", 1e-13, 10},
    p{"p", 0.5, 8, 1, 2, 4};
constexpr harness::Bounds duration{"duration", 0.1, 600, 1}, per_step{"per_step", 1, 13};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<double(double h1, double error1, double h2, double error2)> wanted_order =
    order;
const harness::Within within_order{
    wanted_order,
    {harness_bounds::h1, harness_bounds::error1, harness_bounds::h2, harness_bounds::error2}};

const harness::Wanted<double(double wanted, double h, double error, double p)> wanted_step =
    step_for;
const harness::Within within_step{
    wanted_step,
    {harness_bounds::wanted, harness_bounds::h, harness_bounds::error, harness_bounds::p}};

const harness::Wanted<int(double duration, double h, int per_step)> wanted_evaluations =
    evaluations;
const harness::Within within_evaluations{
    wanted_evaluations, {harness_bounds::duration, harness_bounds::h, harness_bounds::per_step}};

void answer(harness::Call& call) {
  const double a = call.number(), b = call.number(), c = call.number();
  if (call.function() == 2) {
    return call.answer(static_cast<double>(wanted_evaluations(a, b, static_cast<int>(c))));
  }
  const double d = call.number();
  call.answer(call.function() == 0 ? wanted_order(a, b, c, d) : wanted_step(a, b, c, d));
}

#endif
