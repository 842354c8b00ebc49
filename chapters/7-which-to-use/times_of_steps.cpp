// SPDX-License-Identifier: MIT-0
// The times of chapter 7: a step of each method in each thing of the level, and of the
// suspension in several layouts.
#include <array>
#include <string>
#include <tuple>
#include <type_traits>

#include "../times.h"
#include "choose/entrants.h"
#include "folded.h"
#include "level.h"
#include "measure/methods.h"
#include "measure/time_of.h"
#include "particles.h"

namespace {

/// Adds the times of the headers' own functions, which the compiler sees through.
template <class Step, class Scene, class Vec, class Real>
void add(std::vector<measure::Timed>& all, const std::string& thing, Step step, const Scene& scene,
         const scenes::State<Vec>& start, Real h, std::size_t bodies, std::size_t in_a_vec = 1) {
  all.push_back({step_name(thing, bodies, Step::function), [=] {
                   return measure::time_of(step, scene, start, h, bodies / in_a_vec) /
                          double(in_a_vec);
                 }});
}

/// The other methods that a scene can be stepped with: its exact step, one that knows its force,
/// and what takes its damping apart.
template <class Scene>
auto special_methods(const Scene& scene) {
  using namespace measure;
  const std::tuple<LinearDampingImplicitLast, LinearDampingExact> dampers;
  if constexpr (std::is_same_v<Scene, scenes::Toss>) {
    return std::tuple<ConstantAcceleration>();
  } else if constexpr (std::is_same_v<Scene, scenes::Spring<>>) {
    return std::tuple_cat(std::tuple(SpringExact(), folded_once(scene), BackwardEulerSpring()),
                          dampers);
  } else if constexpr (requires { scene.damping(); }) {
    return dampers;
  } else {
    return std::tuple<>();
  }
}

/// A pack full of bodies, all in one place, at rest.
template <class Real>
scenes::State<Lanes<Real>> pack_at(Real x) {
  const typename Lanes<Real>::Part zero{}, place = zero + x;
  return {{place, place, place, place}, {zero, zero, zero, zero}};
}

/// The suspension with numbers of one type, in structs and, for methods that solve for nothing, in
/// packs.
template <class Real>
void add_layouts(std::vector<measure::Timed>& all, const std::string& type) {
  constexpr scenes::Spring<Real> spring{.omega = Real(suspension.omega),
                                        .zeta = Real(suspension.zeta)};
  const Real x0 = Real(suspension.x0);
  list::for_each(list::Among<list::EveryExplicit, list::is_contender>(), [&](auto method) {
    for (const std::size_t bodies : {one_body, in_a_loop, beyond_the_cache}) {
      add(all, "structs of " + type, method, spring, scenes::State<Real>{x0, 0}, Real(brief_step),
          bodies);
    }
    for (const std::size_t bodies : {in_a_loop, beyond_the_cache}) {
      add(all, "packs of " + type, method, spring, pack_at(x0), Real(brief_step), bodies,
          sizeof(Lanes<Real>) / sizeof(Real));
    }
  });
}

}  // namespace

void add_step_times(std::vector<measure::Timed>& all) {
  for_each_thing([&](const std::string& thing, const auto& scene, double) {
    const auto add_to_all = [&](auto method) {
      for (const std::size_t bodies : {one_body, in_a_loop, beyond_the_cache}) {
        add(all, thing, method, scene, scene.start(), brief_step, bodies);
      }
    };
    list::for_each(list::Contenders(), add_to_all);
    std::apply([&](const auto&... method) { (add_to_all(method), ...); }, special_methods(scene));
  });
  add_layouts<double>(all, "double");
  add_layouts<float>(all, "float");
}
