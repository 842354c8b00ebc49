// SPDX-License-Identifier: MIT-0
/// @file
/// All that compete in this chapter, and what they are charged.
#pragma once
#include <iterator>
#include <vector>

#include "bill.h"
#include "measure/compiled.h"

/// The methods that take any acceleration.
inline constexpr auto entrants = measure::all_compiled(list::Contenders());

/// The methods that a scene can be stepped with, those that take its linear damping apart among
/// them.
template <class Scene>
std::vector<const measure::Method*> entrants_on(const Scene& scene) {
  std::vector<const measure::Method*> all(std::begin(entrants), std::end(entrants));
  if constexpr (requires { scene.damping(); }) {
    if (scene.damping() != 0) {
      all.insert(all.end(), {&method::linear_damping_implicit_last, &method::linear_damping_exact});
    }
  }
  return all;
}

/// What a step costs: evaluations of the acceleration and of its derivatives.
template <class Scene>
long price(const measure::Method& method, const Scene& scene, double h) {
  const Billed<Scene> billed{scene};
  auto kept = measure::start(method, scene.start(), h, billed);
  billed.evaluations = 0;
  measure::advance(method, kept, 0.0, h, billed);
  return billed.evaluations;
}
