// SPDX-License-Identifier: MIT-0
/// @file
/// The methods that compete, and what a step of each costs: in evaluations, and in recorded time.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "choose/cost.h"
#include "measure/compiled.h"
#include "measure/times.h"
#include "scenes/spring.h"
#include "scenes/toss.h"

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
  if constexpr (std::is_same_v<Scene, scenes::Toss>) return {&method::constant_acceleration};
  return {};
}

/// The cost of a step: evaluations of the acceleration and of its derivatives. A step that asks for
/// none works the force out itself, and is charged for one.
template <class Scene>
long price(const measure::Method& method, const Scene& scene, double h) {
  const CostCounted<Scene> billed{scene};
  auto memory = measure::start(method, scene.start(), h, billed);
  billed.evaluations = 0;
  measure::advance(method, memory, 0.0, h, billed);
  return std::max(1L, billed.evaluations);
}

/// Evaluations of the acceleration in a step, and one for the derivatives of an implicit method, as
/// the list of the methods has them: for claims about what was counted.
inline double evaluations_per_step(const measure::Method& method) {
  double often = 1;  // those that take damping apart
  list::for_each(list::EveryGeneral(), [&](auto listed) {
    if (listed.function != method.function) return;
    const bool implicit = list::is_in<decltype(listed)>(list::EveryImplicit());
    often = double(listed.evaluations + (implicit ? 1 : 0));
  });
  return often;
}

/// The name of the time of a step of one of so many bodies.
/// @param thing  of the level, such as "shuttle", or a layout, such as "packs of float"
/// @param bodies  how many
/// @param function  of the method
inline std::string step_name(std::string_view thing, std::size_t bodies,
                             std::string_view function) {
  return std::string(thing) + "/" + std::to_string(bodies) + "/" + std::string(function);
}

/// The recorded time of a step of one of so many bodies [ns]; NaN if nobody took it, as of a method
/// that is new.
inline double step_time(std::string_view thing, std::size_t bodies, const measure::Method& method) {
  const auto& times = measure::recorded_times().of;
  const auto time = times.find(step_name(thing, bodies, method.function));
  return time == times.end() ? NAN : time->second.median;
}
