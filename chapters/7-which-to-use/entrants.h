// SPDX-License-Identifier: MIT-0
/// @file
/// All that compete in this chapter, and what they are charged.
#pragma once
#include <algorithm>
#include <iterator>
#include <type_traits>
#include <vector>

#include "bill.h"
#include "level.h"
#include "measure/compiled.h"

/// The methods that take any acceleration.
inline constexpr auto entrants = measure::all_compiled(list::Contenders());

/// The methods that a scene can be stepped with while other forces act as well. Among them are, on
/// a spring, the soft constraint, and where there is linear damping, those that take it apart.
template <class Scene>
std::vector<const measure::Method*> entrants_on(const Scene& scene) {
  std::vector<const measure::Method*> all(std::begin(entrants), std::end(entrants));
  if constexpr (requires { scene.omega, scene.zeta; })
    all.push_back(&method::backward_euler_spring);
  if constexpr (requires { scene.damping(); }) {
    if (scene.damping() != 0) {
      all.insert(all.end(), {&method::linear_damping_implicit_last, &method::linear_damping_exact});
    }
  }
  return all;
}

/// The exact steps of a scene, that for steps of one length first; none if it has no formula.
template <class Scene>
std::vector<const measure::Method*> exact_steps_of(const Scene&) {
  if constexpr (std::is_same_v<Scene, scenes::Spring<>>)
    return {&method::spring_folded, &method::spring_exact};
  if constexpr (std::is_same_v<Scene, Ball>) return {&method::constant_acceleration};
  return {};
}

/// What a step costs: evaluations of the acceleration and of its derivatives. A step that asks for
/// none works the force out itself, and is charged for one.
template <class Scene>
long price(const measure::Method& method, const Scene& scene, double h) {
  const Billed<Scene> billed{scene};
  auto kept = measure::start(method, scene.start(), h, billed);
  billed.evaluations = 0;
  measure::advance(method, kept, 0.0, h, billed);
  return std::max(1L, billed.evaluations);
}
