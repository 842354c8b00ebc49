// SPDX-License-Identifier: MIT-0
/// @file
/// The methods for one kind of force, a spring or a damping, as objects that can be handed on.
#pragma once
#include "integrate/backward_euler_spring.h"
#include "integrate/linear_damping.h"
#include "integrate/rk4_linear.h"
#include "integrate/spring_exact.h"

namespace measure {

/// integrate::backward_euler_spring on a scene with `omega` and `zeta`.
inline constexpr auto backward_euler_spring = [](auto& x, auto& v, auto, auto h,
                                                 const auto& spring) {
  integrate::backward_euler_spring(x, v, h, spring.omega, spring.zeta);
};

/// integrate::spring_exact on a scene with `omega` and `zeta`.
inline constexpr auto spring_exact = [](auto& x, auto& v, auto, auto h, const auto& spring) {
  integrate::spring_exact(x, v, h, spring.omega, spring.zeta);
};

/// integrate::rk4_linear on a scene with `omega` and `damping()`.
inline constexpr auto rk4_linear = [](auto& x, auto& v, auto, auto h, const auto& spring) {
  const auto stiffness = spring.omega * spring.omega;
  integrate::rk4_linear(x, v, integrate::rk4_linear_start(stiffness, spring.damping(), h));
};

/// The acceleration of a scene but for its linear damping: what it would be at rest.
template <class Scene>
auto without_damping(const Scene& scene) {
  return [&scene](const auto& x, const auto& v, auto t) {
    return scene(x, std::decay_t<decltype(v)>(0 * v), t);
  };
}

/// integrate::linear_damping_explicit_last on a scene with `damping()`.
inline constexpr auto linear_damping_explicit_last = [](auto& x, auto& v, auto t, auto h,
                                                        const auto& scene) {
  integrate::linear_damping_explicit_last(x, v, t, h, scene.damping(), without_damping(scene));
};

/// integrate::linear_damping_explicit_first on a scene with `damping()`.
inline constexpr auto linear_damping_explicit_first = [](auto& x, auto& v, auto t, auto h,
                                                         const auto& scene) {
  integrate::linear_damping_explicit_first(x, v, t, h, scene.damping(), without_damping(scene));
};

/// integrate::linear_damping_implicit_last on a scene with `damping()`.
inline constexpr auto linear_damping_implicit_last = [](auto& x, auto& v, auto t, auto h,
                                                        const auto& scene) {
  integrate::linear_damping_implicit_last(x, v, t, h, scene.damping(), without_damping(scene));
};

/// integrate::linear_damping_implicit_first on a scene with `damping()`.
inline constexpr auto linear_damping_implicit_first = [](auto& x, auto& v, auto t, auto h,
                                                         const auto& scene) {
  integrate::linear_damping_implicit_first(x, v, t, h, scene.damping(), without_damping(scene));
};

/// integrate::linear_damping_exponential_last on a scene with `damping()`.
inline constexpr auto linear_damping_exponential_last = [](auto& x, auto& v, auto t, auto h,
                                                           const auto& scene) {
  integrate::linear_damping_exponential_last(x, v, t, h, scene.damping(), without_damping(scene));
};

/// integrate::linear_damping_exponential_first on a scene with `damping()`.
inline constexpr auto linear_damping_exponential_first = [](auto& x, auto& v, auto t, auto h,
                                                            const auto& scene) {
  integrate::linear_damping_exponential_first(x, v, t, h, scene.damping(), without_damping(scene));
};

/// integrate::linear_damping_exact on a scene with `damping()`.
inline constexpr auto linear_damping_exact = [](auto& x, auto& v, auto t, auto h,
                                                const auto& scene) {
  integrate::linear_damping_exact(x, v, t, h, scene.damping(), without_damping(scene));
};

}  // namespace measure
