// SPDX-License-Identifier: MIT-0
/// @file
/// What is left of a blow in chapter 4, and how often each step is solved for it.
#pragma once
#include <cmath>
#include <optional>

#include "../cast.h"
#include "integrate/bdf2.h"
#include "integrate/trapezoid.h"
#include "measure/energy.h"
#include "measure/methods.h"
#include "measure/record.h"
#include "struck_nets.h"

/// What one step of backward Euler leaves of the energy of an undamped spring.
constexpr double left_in_a_step(double homega) {
  return 1 / (1 + homega * homega);
}

/// What a second of BDF2 leaves of the energy of an undamped spring.
inline double left_by_bdf2(const scenes::Spring<>& spring) {
  const auto energy = [&](double x, double v) { return spring.energy(x, v); };
  return 1 + measure::drift(measure::bdf2, spring, frame, 60, energy).last;
}

/// The same, begun with a step of another method.
/// @param first  takes it, as `first(x, v, t, h, scene)`
template <class First>
double left_by_bdf2(const scenes::Spring<>& spring, First first) {
  auto [x, v] = spring.start();
  integrate::Bdf2Previous<double> previous{x, v};
  const double given = spring.energy(x, v);
  const auto solve = measure::solver_of(spring);
  first(x, v, 0.0, frame, spring);
  for (int n = 1; n < 60; ++n) {
    if (!integrate::bdf2(x, v, previous, n * frame, frame, frame, spring, solve)) return NAN;
  }
  return spring.energy(x, v) / given;
}

/// A norm that lets Newton's method end with its second iteration, if its tolerance is below one.
inline auto content_after_two() {
  return [done = 0](const Eigen::VectorXd&) mutable { return ++done < 2 ? 1.0 : 0.0; };
}

/// Two solves of backward Euler.
inline constexpr auto solved_twice = [](Struck& s, const auto& scene, auto& system) {
  return integrate::backward_euler_newton(s.x, s.v, 0.0, frame, scene, system, content_after_two(),
                                          0.5) > 0;
};

/// One solve of the trapezoid rule.
inline constexpr auto trapezoid_once = [](Struck& s, const auto& scene, auto& system) {
  return integrate::trapezoid(s.x, s.v, 0.0, frame, scene, system);
};

/// The trapezoid rule to the end of Newton's method.
inline constexpr auto trapezoid_to_the_end = [](Struck& s, const auto& scene, auto& system) {
  return integrate::trapezoid_newton(s.x, s.v, 0.0, frame, scene, system, largest, tolerance) > 0;
};

/// Iterations of Newton's method in a step of the trapezoid rule, on average; 0 if one failed.
template <class Scene>
double solves_of_trapezoid(const Scene& scene, double speed, int steps) {
  Struck s = struck(scene, speed);
  auto system = system_of(scene);
  long sum = 0;
  for (int n = 0; n < steps; ++n) {
    const int solves =
        integrate::trapezoid_newton(s.x, s.v, 0.0, frame, scene, system, largest, tolerance);
    if (solves == 0) return 0;
    sum += solves;
  }
  return double(sum) / steps;
}

/// Begins BDF2 in the first frame, and takes a step of it in each; for one blow.
/// @param step  called as `step(s, previous, scene, system)`; returns whether it was solved
template <class Step>
auto begun_by_itself(Step step) {
  using Previous = integrate::Bdf2Previous<Eigen::VectorXd>;
  return [step, previous = std::optional<Previous>()](Struck& s, const auto& scene,
                                                      auto& system) mutable {
    if (!previous) previous = integrate::bdf2_start(s.x, s.v, 0.0, frame, scene);
    return step(s, *previous, scene, system);
  };
}

/// One solve of BDF2; for one blow.
inline auto bdf2_once() {
  return begun_by_itself([](Struck& s, auto& previous, const auto& scene, auto& system) {
    return integrate::bdf2(s.x, s.v, previous, 0.0, frame, frame, scene, system);
  });
}

/// Two solves of BDF2; for one blow.
inline auto bdf2_twice() {
  return begun_by_itself([](Struck& s, auto& previous, const auto& scene, auto& system) {
    return integrate::bdf2_newton(s.x, s.v, previous, 0.0, frame, frame, scene, system,
                                  content_after_two(), 0.5) > 0;
  });
}

/// A gentle blow, and what a second leaves of it.
void a_second(measure::Record& record);

/// A hard blow, solved once a step and to the end.
void hard_blow(measure::Record& record);

/// How much each of Newton's iterations changes in one step.
void newton(measure::Record& record);
