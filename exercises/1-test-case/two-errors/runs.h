// SPDX-License-Identifier: MIT-0
/// @file
/// Runs whose errors follow C h^p, and what may be made of them by mistake.
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "format_values.h"
#include "judge/diagnose.h"

namespace runs {

using Says = std::vector<std::string>;

struct Runs {
  double h1, error1, h2, error2;

  double order() const { return std::log(error1 / error2) / std::log(h1 / h2); }

  /// Whether C is the same by both runs, with this order.
  bool have_order(double p) const {
    return std::abs(error1 / std::pow(h1, p) / (error2 / std::pow(h2, p)) - 1) <= 1e-10;
  }
};

inline Says recognise_order(double got, const Runs& two) {
  const Runs halved{1, two.error1, 0.5, two.error2};
  if (halved.have_order(got))
    return {"this is right for a second step of half the first; here it is " +
            grade::number(two.h2 / two.h1, 3) + " of it"};
  if (two.have_order(1 / got)) return {"this is 1 over the order: the quotient is upside down"};
  if (two.have_order(-got))
    return {"this is minus the order: one of the two quotients is upside down"};
  if (got == std::round(two.order()))
    return {"rounded to a whole number; what two runs show need not be one"};
  if (std::abs(got * (two.h1 - two.h2) / (two.error1 - two.error2) - 1) < 1e-10)
    return {"this is the slope without logarithms"};
  return judge::diagnose(got, two.order());
}

/// A run, its order, and the error that it should have had.
struct Wanted {
  double wanted, h, error, p;

  double error_with(double step, double order) const { return error * std::pow(step / h, order); }
  bool fits(double step, double order) const {
    return std::abs(error_with(step, order) / wanted - 1) < 1e-10;
  }
};

inline Says recognise_step(double got, const Wanted& ask) {
  const double whole = std::floor(ask.p);
  if (ask.fits(got, 1)) return {"this is right for a method of order 1, and this one has another"};
  if (ask.fits(got, 1 / ask.p))
    return {
        "the power of p where its root is needed: the error goes with the step to the power of "
        "p, and the step with the error to the power of 1/p"};
  if (ask.fits(got, whole))
    return {"this is right for an order of " + grade::number(whole) +
            ": is p cut to a whole number?"};
  if (std::abs(got / ask.h - 1) < 1e-10)
    return {
        "this is the step of the run: is there a division of whole numbers, such as 1 / 2, "
        "which is 0?"};
  if (ask.fits(ask.h * ask.h / got, ask.p)) return {"the quotient of the errors is upside down"};
  if (std::abs(ask.error_with(got, ask.p) / ask.wanted - 1) < 1e-5)
    return {"right to seven digits and no further: a float, or a constant with an f?"};
  return {};
}

}  // namespace runs
