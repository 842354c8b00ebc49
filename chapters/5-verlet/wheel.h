// SPDX-License-Identifier: MIT-0
/// @file
/// A wheel that turns freely, by position Verlet on what a rigid body keeps.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "rope.h"

inline constexpr double spin =
    2 * std::numbers::pi;  ///< at the start: once round in a second [rad/s]

inline constexpr auto nothing = [](const auto& x, const auto&,
                                   double) -> std::decay_t<decltype(x)> { return 0.0 * x; };

/// A direction in the plane, the first column of a rotation matrix.
inline Vec direction(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// A direction that turns: where it points, where it did, and how it is kept.
struct Spoke {
  double h;
  Vec x = direction(0), x_previous = direction(-spin * h);

  // [spoke]
  void step() { integrate::stormer_verlet(x, x_previous, 0.0, h, nothing); }

  void step_and_normalize() {
    step();
    x.normalize();
  }
  // [spoke]

  /// How fast it turns [rad/s].
  double speed() const {
    return std::atan2(x_previous.x() * x.y() - x_previous.y() * x.x(), x_previous.dot(x)) / h;
  }
};

/// Four points and the six sticks between them.
struct Box {
  std::array<Vec, 4> x{Vec{0.5, 0.5}, Vec{-0.5, 0.5}, Vec{-0.5, -0.5}, Vec{0.5, -0.5}};
  std::array<Vec, 4> x_previous;
  double h;

  explicit Box(double step) : h(step) {
    const Eigen::Rotation2Dd back(-spin * h);
    for (std::size_t i = 0; i < 4; ++i) x_previous[i] = back * x[i];
  }

  void step(int iterations) {
    for (std::size_t i = 0; i < 4; ++i) {
      integrate::stormer_verlet(x[i], x_previous[i], 0.0, h, nothing);
    }
    for (; iterations > 0; --iterations) {
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) {
          const double length = (i + j) % 2 == 1 ? 1 : std::numbers::sqrt2;
          const Vec d = x[j] - x[i];
          const Vec half = (1 - length / d.norm()) / 2 * d;
          x[i] += half;
          x[j] -= half;
        }
      }
    }
  }

  /// Angular momentum over moment of inertia, at the middle of the last step [rad/s].
  double speed() const {
    double momentum = 0, inertia = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec v = (x[i] - x_previous[i]) / h, middle = (x[i] + x_previous[i]) / 2;
      momentum += middle.x() * v.y() - middle.y() * v.x();
      inertia += middle.squaredNorm();
    }
    return momentum / inertia;
  }
};
