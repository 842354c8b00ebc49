// SPDX-License-Identifier: MIT-0
/// @file
/// The mass-spring systems of chapter 4, chain, rope and cloth of steel: their blows, and the
/// linear systems that move them.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "../../cast_of_many.h"
#include "integrate/backward_euler.h"
#include "integrate/band_system.h"
#include "integrate/sparse_system.h"

inline constexpr double gentle = 0.1;  ///< speed of a gentle blow [m/s]
inline constexpr double hard = 1;      ///< speed of a hard blow [m/s]

/// The name of the time of a frame of a net, for each unknown.
/// @param net  "chain", "rope" or "cloth"
/// @param function  of the method
inline std::string frame_name(const std::string& net, const std::string& function) {
  return "frame of a " + net + "/" + function;
}

/// Places and velocities of all masses, in one column each.
using MassSpringState = scenes::State<Eigen::VectorXd>;

/// The state right after a blow: every mass that is not held has a random velocity.
/// @param speed  the largest along each axis [m/s]
/// @param draw  another one is another blow
template <class Scene>
MassSpringState with_random_velocities(const Scene& scene, double speed, unsigned draw = 1) {
  MassSpringState s = scene.start();
  std::mt19937 dice(draw);
  for (double& v : s.v) v = speed * (double(dice()) / 2147483648.0 - 1);
  if constexpr (requires { scene.held(0); }) {
    for (int i = 0; i < scene.nodes(); ++i) {
      if (scene.held(i)) s.v.template segment<3>(3 * i).setZero();
    }
  }
  return s;
}

/// The derivatives of a scene's acceleration, as the linear systems want them.
template <class Scene>
auto jacobian_of(const Scene& scene) {
  return
      [&scene](const auto& x, const auto& v, auto t, auto&& add) { scene.jacobian(x, v, t, add); };
}

// [system]
template <class Real>
auto system_of(const scenes::Chain<Real>& scene) {
  const auto jacobian = jacobian_of(scene);
  return integrate::BandSystem<1, decltype(jacobian), Real>(jacobian);
}
template <class Real>
auto system_of(const scenes::Rope<Real>& scene) {
  const auto jacobian = jacobian_of(scene);
  return integrate::BandSystem<5, decltype(jacobian), Real>(jacobian);
}
template <class Real>
auto system_of(const scenes::Cloth<Real>& scene) {
  const auto jacobian = jacobian_of(scene);
  return integrate::SparseSystem<decltype(jacobian), Real>(jacobian);
}
// [system]

/// The largest change of any velocity.
inline constexpr auto largest_change = [](const Eigen::VectorXd& change) {
  return change.size() > 0 ? change.cwiseAbs().maxCoeff() : 0.0;
};

/// The largest change of a velocity with which Newton's method has converged [m/s].
inline constexpr double newton_tolerance = 1e-9;

/// Shares of the energy that are left after each step of a blow; the first is 1.
/// @param step  called as `step(state, scene, system)`, true if it could be taken
/// @param draw  of the blow; see with_random_velocities()
template <class Scene, class Step>
std::vector<double> energy_shares(const Scene& scene, double speed, int steps, Step step,
                                  unsigned draw = 1) {
  MassSpringState s = with_random_velocities(scene, speed, draw);
  auto system = system_of(scene);
  const double first = scene.energy(s.x, s.v);
  std::vector<double> left{1};
  for (int n = 0; n < steps && step(s, scene, system); ++n) {
    left.push_back(scene.energy(s.x, s.v) / first);
  }
  return left;
}

/// One solve of backward Euler.
inline constexpr auto solved_once = [](MassSpringState& s, const auto& scene, auto& system) {
  return integrate::backward_euler(s.x, s.v, 0.0, frame, scene, system);
};

/// Backward Euler, solved until Newton's method converges.
inline constexpr auto newton_converged = [](MassSpringState& s, const auto& scene, auto& system) {
  return integrate::backward_euler_newton(s.x, s.v, 0.0, frame, scene, system, largest_change,
                                          newton_tolerance) > 0;
};

/// The largest change of a velocity in each of Newton's iterations of the first step after a blow.
template <class Scene>
std::vector<double> newton_changes(const Scene& scene, double speed) {
  MassSpringState s = with_random_velocities(scene, speed);
  auto system = system_of(scene);
  std::vector<double> found;
  const auto note = [&found](const Eigen::VectorXd& change) {
    found.push_back(largest_change(change));
    return found.back();
  };
  if (integrate::backward_euler_newton(s.x, s.v, 0.0, frame, scene, system, note,
                                       newton_tolerance) == 0) {
    found.clear();
  }
  return found;
}
