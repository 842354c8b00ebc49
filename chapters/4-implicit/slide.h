// SPDX-License-Identifier: MIT-0
/// @file
/// Two formulas from the talks, as their slides have them, in chapter 4.
#pragma once
#include <Eigen/Dense>
#include <type_traits>

#include "scenes/state.h"

/// The talk's example of a predictor-corrector.
inline constexpr auto slide = [](auto& x, auto& v, double t, double h, const auto& acceleration) {
  using Vec = std::decay_t<decltype(x)>;
  // [predictor-corrector]
  const Vec a = acceleration(x, v, t);
  const Vec x_ahead = x + h * v;
  const Vec v_ahead = v + h * a;
  const Vec a_ahead = acceleration(x_ahead, v_ahead, t + h);
  x = x + h / 2 * (v_ahead + v);
  v = v + h / 2 * (a_ahead + a);
  // [predictor-corrector]
};

/// The talk's linear system, for position and velocity in one column: (1/h - f') change = f.
template <class Scene>
void slide_system(scenes::State<Eigen::VectorXd>& s, double h, const Scene& scene) {
  const Eigen::Index n = s.x.size();
  Eigen::MatrixXd derivative = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  derivative.topRightCorner(n, n).setIdentity();
  scene.jacobian(s.x, s.v, 0.0, [&](int i, int j, double dadx, double dadv) {
    derivative(n + i, j) += dadx;
    derivative(n + i, n + j) += dadv;
  });
  Eigen::VectorXd slope(2 * n);
  slope << s.v, scene(s.x, s.v, 0.0);
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(2 * n, 2 * n) / h - derivative;
  const Eigen::VectorXd change = matrix.partialPivLu().solve(slope);
  s.x += change.head(n);
  s.v += change.tail(n);
}
