// SPDX-License-Identifier: MIT-0
// What the orders are measured on: scenes with starts that have no symmetry, and the truth at eight
// times of a run, none of them a full period.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "reference.h"
#include "scenes/orbit.h"
#include "scenes/state.h"
#include "textbook/problem.h"

namespace order {

using scenes::State;

template <class Real, class Scene, class Vec = Real>
struct Problem {
  Scene scene;
  State<Vec> start;
  Real part;                        // time from one truth to the next
  std::array<State<Vec>, 8> truth;  // after one part, two, and so on
  std::array<int, 6> steps;         // in a part of the coarsest run, by the order of the method
};

// The truth, made in long double by `after`, in the numbers of the method.
template <class Real, class After>
std::array<State<Real>, 8> rounded(After after) {
  std::array<State<Real>, 8> truth;
  for (std::size_t n = 0; n < 8; ++n) {
    const State<long double> s = after(static_cast<long double>(n + 1));
    truth[n] = {static_cast<Real>(s.x), static_cast<Real>(s.v)};
  }
  return truth;
}

template <class Real, class Scene>
std::array<State<Real>, 8> by_reference(const Scene& scene, const State<Real>& start, Real part) {
  State<long double> s{start.x, start.v};
  return rounded<Real>(
      [&](long double n) { return s = reference::after(scene, s, (n - 1) * part, n * part); });
}

// Far enough to be nothing like a spring. The book's own sine knows no long double.
struct Pendulum {
  template <class V, class Time>
  V operator()(const V& x, const V&, Time) const {
    return -std::sin(x);
  }
  template <class V, class Time, class Add>
  void jacobian(const V& x, const V&, Time, Add&& add) const {
    add(0, 0, -std::cos(x), V(0));
  }
};

template <class Real>
Problem<Real, Pendulum> pendulum() {
  const State<Real> start{Real(1.875), Real(0.375)};
  const Real part = Real(0.7);
  return {{}, start, part, by_reference(Pendulum(), start, part), {0, 300, 40, 0, 16, 16}};
}

// Starts on the way out and goes round once and a little more.
template <class Real>
Problem<Real, scenes::Orbit<Real>, typename scenes::Orbit<Real>::Vec> kepler() {
  const scenes::Orbit<Real> planet{.eccentricity = Real(0.6)};
  const Real begin = 2, part = Real(1.1);
  std::array<State<typename scenes::Orbit<Real>::Vec>, 8> truth;
  for (std::size_t n = 0; n < 8; ++n) truth[n] = planet.exact(begin + Real(n + 1) * part);
  return {planet, planet.exact(begin), part, truth, {0, 3000, 200, 0, 200, 170}};
}

// x'' = -4 x + cos(3 t), whose answer is a wave of its own and one of the force's.
struct Driven {
  template <class V, class Time>
  V operator()(const V& x, const V&, Time t) const {
    return V(-4) * x + std::cos(V(3) * V(t));
  }
  template <class V, class Time, class Add>
  void jacobian(const V&, const V&, Time, Add&& add) const {
    add(0, 0, V(-4), V(0));
  }
  static State<long double> exact(long double t) {
    const long double c = std::cos(2 * t), s = std::sin(2 * t);
    return {c / 2 + s / 3 - std::cos(3 * t) / 5, -s + 2 * c / 3 + 3 * std::sin(3 * t) / 5};
  }
};

// Also for a run back, with a negative part.
template <class Real>
Problem<Real, Driven> driven(Real part) {
  const auto truth = rounded<Real>([part](long double n) { return Driven::exact(n * part); });
  const State<long double> start = Driven::exact(0);
  return {{}, {Real(start.x), Real(start.v)}, part, truth, {0, 200, 30, 0, 12, 12}};
}

// Not linear, and with drag: the force depends on position, velocity and time.
template <class Real>
Problem<Real, textbook::Pushed> pushed() {
  const State<Real> start{Real(0.6875), Real(0.5)};
  const Real part = Real(0.5);
  const textbook::Pushed scene;
  return {scene, start, part, by_reference(scene, start, part), {0, 100, 20, 0, 16, 32}};
}

}  // namespace order
