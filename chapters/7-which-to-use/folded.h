// SPDX-License-Identifier: MIT-0
/// @file
/// The exact step of springs that have their four numbers in common, as it is timed.
#pragma once
#include <string_view>

#include "choose/cost.h"
#include "integrate/spring_exact.h"
#include "measure/methods/spring.h"

/// A step by numbers that were worked out once.
struct FoldedOnce {
  static constexpr std::string_view function = measure::SpringFolded::function;
  integrate::SpringFolded<double> numbers;

  void operator()(double& x, double& v, double, double, const auto&) const {
    integrate::spring_folded(x, v, numbers);
  }
};

/// The step that is timed for a spring.
template <class Spring>
FoldedOnce folded_once(const Spring& spring) {
  return {integrate::spring_folded_start(brief_step, spring.omega, spring.zeta)};
}
