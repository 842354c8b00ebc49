// SPDX-License-Identifier: MIT-0
// One step of any method of the list by a direct call of its header, at any time and for any type
// of clock; what a method keeps is made from position and velocity, and read off again.
#pragma once
#include "measure/methods.h"
#include "scenes/state.h"

template <class Method, class Vec, class Time, class Real, class Scene>
constexpr scenes::State<Vec> one_step(Method, scenes::State<Vec> s, Time t, Real h,
                                      const Scene& scene) {
  Method()(s.x, s.v, t, h, scene);
  return s;
}

template <class Vec, class Time, class Real, class Scene>
constexpr scenes::State<Vec> one_step(measure::StormerVerlet, scenes::State<Vec> s, Time t, Real h,
                                      const Scene& scene) {
  Vec x_previous = integrate::stormer_verlet_start(s.x, s.v, t, h, scene);
  integrate::stormer_verlet(s.x, x_previous, t, h, scene);
  return {s.x, integrate::stormer_verlet_velocity(s.x, x_previous, h)};
}

template <class Vec, class Time, class Real, class Scene>
constexpr scenes::State<Vec> one_step(measure::StormerVerletUneven, scenes::State<Vec> s, Time t,
                                      Real h, const Scene& scene) {
  Vec x_previous = integrate::stormer_verlet_start(s.x, s.v, t, h / Real(4), scene);
  integrate::stormer_verlet_uneven(s.x, x_previous, t, h, h / Real(4), scene);
  return {s.x, integrate::stormer_verlet_velocity(s.x, x_previous, h)};
}

template <class Vec, class Time, class Real, class Scene>
constexpr scenes::State<Vec> one_step(measure::StormerVerletDistance, scenes::State<Vec> s, Time t,
                                      Real h, const Scene& scene) {
  Vec distance = integrate::stormer_verlet_distance_start(s.x, s.v, t, h, scene);
  integrate::stormer_verlet_distance(s.x, distance, t, h, scene);
  return {s.x, (Real(1) / h) * distance};
}

template <class Vec, class Time, class Real, class Scene>
constexpr scenes::State<Vec> one_step(measure::StormerVerletCarried, scenes::State<Vec> s, Time t,
                                      Real h, const Scene& scene) {
  Vec a = scene(s.x, s.v, t);
  Vec x_previous = integrate::stormer_verlet_start(s.x, s.v, t, h, scene);
  integrate::stormer_verlet_carried(s.x, x_previous, a, t, h, scene);
  return {s.x, integrate::stormer_verlet_carried_velocity(s.x, x_previous, a, h)};
}

template <class Vec, class Time, class Real, class Scene>
constexpr scenes::State<Vec> one_step(measure::Leapfrog, scenes::State<Vec> s, Time t, Real h,
                                      const Scene& scene) {
  Vec v_half = integrate::leapfrog_start(s.x, s.v, t, h, scene);
  integrate::leapfrog(s.x, v_half, t, h, scene);
  return {s.x, integrate::leapfrog_velocity(s.x, v_half, t + h, h, scene)};
}

template <class Vec, class Time, class Real, class Scene>
constexpr scenes::State<Vec> one_step(measure::VelocityVerlet, scenes::State<Vec> s, Time t, Real h,
                                      const Scene& scene) {
  Vec a = integrate::velocity_verlet_start(s.x, s.v, t, scene);
  integrate::velocity_verlet(s.x, s.v, a, t, h, scene);
  return s;
}

template <class Vec, class Time, class Real, class Scene>
constexpr scenes::State<Vec> one_step(measure::Yoshida4, scenes::State<Vec> s, Time t, Real h,
                                      const Scene& scene) {
  Vec a = integrate::yoshida4_start(s.x, s.v, t, scene);
  integrate::yoshida4(s.x, s.v, a, t, h, scene);
  return s;
}

template <class Vec, class Time, class Real, class Scene>
constexpr scenes::State<Vec> one_step(measure::Dopri5, scenes::State<Vec> s, Time t, Real h,
                                      const Scene& scene) {
  Vec a = integrate::dopri5_start(s.x, s.v, t, scene);
  const auto error = integrate::dopri5(s.x, s.v, a, t, h, scene);
  return {s.x + error.x, s.v + error.v};
}

// The implicit ones, on a scene of one unknown with a `jacobian`.
template <class Scene>
constexpr auto solver(const Scene& scene) {
  return [&scene](const auto& x, const auto& v, auto t, auto p, auto q, auto& change) {
    scene.jacobian(x, v, t, [&](int, int, auto dadx, auto dadv) {
      change = change / (decltype(p)(1) + p * dadx + q * dadv);
    });
    return true;
  };
}

inline constexpr auto size_of_change = [](const auto& y) { return y < 0 ? -y : y; };

template <class Vec, class Time, class Real, class Scene>
constexpr scenes::State<Vec> one_step(measure::BackwardEuler, scenes::State<Vec> s, Time t, Real h,
                                      const Scene& scene) {
  const bool solved = integrate::backward_euler(s.x, s.v, t, h, scene, solver(scene));
  return solved ? s : scenes::State<Vec>{};
}

template <class Vec, class Time, class Real, class Scene>
constexpr scenes::State<Vec> one_step(measure::Trapezoid, scenes::State<Vec> s, Time t, Real h,
                                      const Scene& scene) {
  const bool solved = integrate::trapezoid(s.x, s.v, t, h, scene, solver(scene));
  return solved ? s : scenes::State<Vec>{};
}

template <class Vec, class Time, class Real, class Scene>
constexpr scenes::State<Vec> one_step(measure::Bdf2, scenes::State<Vec> s, Time t, Real h,
                                      const Scene& scene) {
  const Real before = h / Real(4);
  auto previous = integrate::bdf2_start(s.x, s.v, t, before, scene);
  const bool solved = integrate::bdf2(s.x, s.v, previous, t, h, before, scene, solver(scene));
  return solved ? s : scenes::State<Vec>{};
}

template <class Vec, class Time, class Real, class Scene>
constexpr scenes::State<Vec> one_step(measure::BackwardEulerNewton, scenes::State<Vec> s, Time t,
                                      Real h, const Scene& scene) {
  const int iterations = integrate::backward_euler_newton(s.x, s.v, t, h, scene, solver(scene),
                                                          size_of_change, Real(1e-5));
  return iterations > 0 ? s : scenes::State<Vec>{};
}

template <class Vec, class Time, class Real, class Scene>
constexpr scenes::State<Vec> one_step(measure::TrapezoidNewton, scenes::State<Vec> s, Time t,
                                      Real h, const Scene& scene) {
  const int iterations =
      integrate::trapezoid_newton(s.x, s.v, t, h, scene, solver(scene), size_of_change, Real(1e-5));
  return iterations > 0 ? s : scenes::State<Vec>{};
}

template <class Vec, class Time, class Real, class Scene>
constexpr scenes::State<Vec> one_step(measure::Bdf2Newton, scenes::State<Vec> s, Time t, Real h,
                                      const Scene& scene) {
  const Real before = h / Real(4);
  auto previous = integrate::bdf2_start(s.x, s.v, t, before, scene);
  const int iterations = integrate::bdf2_newton(s.x, s.v, previous, t, h, before, scene,
                                                solver(scene), size_of_change, Real(1e-5));
  return iterations > 0 ? s : scenes::State<Vec>{};
}
