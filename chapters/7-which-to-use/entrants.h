// SPDX-License-Identifier: MIT-0
/// @file
/// All that compete in this chapter, and what they are charged.
#pragma once
#include <string>

#include "measure/cost.h"
#include "measure/implicit_methods.h"
#include "measure/linear_methods.h"
#include "measure/methods_with_memory.h"

/// The header that has a function of the book's.
inline std::string header_of(const std::string& function) {
  return (function.starts_with("linear_damping") ? "linear_damping" : function) + ".h";
}

/// Calls `visit(name, function, step)` for each method that takes any acceleration.
template <class Visit>
void for_each_entrant(Visit visit) {
  visit("Euler", "euler", measure::euler);
  visit("symplectic Euler", "symplectic_euler", measure::symplectic_euler);
  visit("leapfrog", "leapfrog", measure::leapfrog);
  visit("Störmer–Verlet", "stormer_verlet", measure::stormer_verlet);
  visit("velocity Verlet", "velocity_verlet", measure::velocity_verlet);
  visit("Yoshida 4", "yoshida4", measure::yoshida4);
  visit("midpoint", "midpoint", measure::midpoint);
  visit("Heun", "heun", measure::heun);
  visit("RK4", "rk4", measure::rk4);
  visit("Dormand-Prince", "dopri5", measure::dopri5);
  visit("predicted Euler", "predicted_euler", measure::predicted_euler<1>);
  visit("backward Euler", "backward_euler", measure::backward_euler);
  visit("trapezoid", "trapezoid", measure::trapezoid);
}

/// Calls `visit(name, function, step)` for each method that a scene can be stepped with, those that
/// take its linear damping apart among them.
template <class Scene, class Visit>
void for_each_entrant_on(const Scene& scene, Visit visit) {
  for_each_entrant(visit);
  if constexpr (requires { scene.damping(); }) {
    if (scene.damping() == 0) return;
    visit("symplectic Euler, drag divided", "linear_damping_implicit_last",
          measure::linear_damping_implicit_last);
    visit("symplectic Euler, drag exact", "linear_damping_exact", measure::linear_damping_exact);
  }
}

// [bill]
/// A scene that charges for its acceleration, and as much again for the derivatives of it that an
/// implicit method asks for. Solving the equations is on the house.
template <class Scene>
struct Billed : measure::Counted<Scene> {
  using measure::Counted<Scene>::Counted;

  /// Charges, and hands the derivatives on.
  template <class Vec, class Time, class Add>
  void jacobian(const Vec& x, const Vec& v, Time t, Add&& add) const {
    ++this->evaluations;
    Scene::jacobian(x, v, t, add);
  }
};
// [bill]

/// What a step costs: evaluations of the acceleration and of its derivatives.
template <class Step, class Scene>
long price(const Step& step, const Scene& scene, double h) {
  const Billed<Scene> billed{scene};
  auto kept = measure::start(step, scene.start(), h, billed);
  billed.evaluations = 0;
  measure::advance(step, kept, 0.0, h, billed);
  return billed.evaluations;
}
