// SPDX-License-Identifier: MIT-0
// One implicit step of a stiff scene, by whom, and whether they all take the same one.
#pragma once
#include <Eigen/Core>
#include <cstdio>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "rows.h"
#include "scenes/state.h"

namespace implicit {

using State = scenes::State<Eigen::VectorXd>;
using Step = std::function<void(State&, double)>;

constexpr double h = 1 / 60.0;  ///< step size [s]

/// Mass and stiffness of every scene: h times the frequency of one spring is 50.
constexpr double mass = 0.01, k = 2500 * mass / (h * h);

struct Variant {
  peers::Row row;
  Step step;
  bool same = true;  ///< whether it is the step of the first one, by other means
};

/// In its place, but struck: every mass has a speed of its own, unless it is held.
template <class Scene>
State struck(const Scene& scene) {
  State s = scene.start();
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> speed(-0.1, 0.1);
  for (double& v : s.v) v = speed(engine);
  if constexpr (requires { scene.held(0); }) {
    for (int i = 0; i < scene.nodes(); ++i) {
      if (scene.held(i)) s.v.segment<3>(3 * i).setZero();
    }
  }
  return s;
}

inline State after(const Step& step, State s, int steps) {
  for (int n = 0; n < steps; ++n) step(s, h);
  return s;
}

/// What a second makes of the energy of a scene, for a note. With a tenth to spare until its limit,
/// symplectic Euler shows up to 6 times the energy of a mode, which its steps give back.
template <class Scene>
std::string energy_after_a_second(const Scene& scene, const State& start, const Step& step) {
  const State end = after(step, start, 60);
  const double share = scene.energy(end.x, end.v) / scene.energy(start.x, start.v);
  if (!(share < 6)) throw std::runtime_error("a step that should be stable is not");
  char text[80];
  std::snprintf(text, sizeof text, "after a second, %.2g times the energy", share);
  return text;
}

/// How far three steps may lead apart. A spring as stiff as these answers a rounding of x with a
/// change of v that takes it back in one step; and the matrix, whose condition is about 2e4, may
/// blow up roundings of v by as much.
inline double allowed(const State& s) {
  const double rounding = std::numeric_limits<double>::epsilon();
  return rounding * (10 * s.x.cwiseAbs().maxCoeff() / h + 2e4 * s.v.cwiseAbs().maxCoeff());
}

/// Whether all steps lead to the same place.
inline bool agree(const std::vector<Variant>& variants, const State& start) {
  const State first = after(variants.front().step, start, 3);
  bool all = true;
  for (const auto& [row, step, same] : variants) {
    if (!same) continue;
    const double away = (after(step, start, 3).v - first.v).cwiseAbs().maxCoeff();
    if (away <= allowed(start)) continue;
    std::fprintf(stderr, "%s: %s ends %g m/s from where the first one ends\n", row.group.c_str(),
                 row.variant.c_str(), away);
    all = false;
  }
  return all;
}

/// A program that has run for a while has given back some large block. From then on glibc keeps
/// what it is given back; before, it may fetch the vectors of each step from the system again.
inline void run_for_a_while() {
  benchmark::DoNotOptimize(std::vector<double>(1 << 20, 1.0).data());
}

/// @param steps  how many to take from the start in one go
/// @param masses  time is measured for a step of one of so many
inline void add(const std::vector<Variant>& variants, const State& start, int steps, long masses) {
  for (const Variant& variant : variants) {
    peers::add_row(variant.row, steps * masses, [step = variant.step, start, steps] {
      const State end = after(step, start, steps);
      benchmark::DoNotOptimize(end.x.data());
    });
  }
}

}  // namespace implicit
