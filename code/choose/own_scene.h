// SPDX-License-Identifier: MIT-0
/// @file
/// A scene of the reader's own: from a header with an acceleration and a start, all that the
/// contest asks of a scene.
///
/// The header defines `Vec`, which is `double` or an Eigen vector of doubles; the function
/// `Vec acceleration(const Vec& x, const Vec& v, double t)`; and the constants `start_x` and
/// `start_v`. It is included before this file.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "integrate/dopri5.h"
#include "measure/length.h"
#include "scenes/state.h"

/// The type that the methods move: they are compiled for these.
using Moved =
    std::conditional_t<std::is_same_v<Vec, double> || std::is_same_v<Vec, Eigen::Vector2d>, Vec,
                       Eigen::VectorXd>;

/// The numbers of a vector, and how many there are.
inline double* numbers_of(double& x) {
  return &x;
}
template <class Eigens>
double* numbers_of(Eigen::PlainObjectBase<Eigens>& x) {
  return x.data();
}
inline int numbers_in(double) {
  return 1;
}
template <class Eigens>
int numbers_in(const Eigen::PlainObjectBase<Eigens>& x) {
  return int(x.size());
}

/// The reader's scene, with a truth and derivatives that are found by running it.
class OwnScene {
 public:
  /// The acceleration.
  Moved operator()(const Moved& x, const Moved& v, double t) const {
    return Moved(acceleration(Vec(x), Vec(v), t));
  }

  /// The start.
  scenes::State<Moved> start() const { return {Moved(Vec(start_x)), Moved(Vec(start_v))}; }

  /// The truth at a time, by Dormand-Prince.
  /// @throws std::runtime_error  it gets no farther, since the acceleration is not finite, or jumps
  scenes::State<Moved> exact(double t) const {
    // Never back in time: what a damper took away comes back with all errors magnified.
    if (!path_ || t < path_->t_before)
      path_ = integrate::dopri5_path(start().x, start().v, 0.0, 1e-3, *this);
    const auto norm = [](const Moved& error) { return measure::length(error); };
    const double size = 1 + measure::length(start().x) + measure::length(start().v);
    if (!integrate::dopri5_adaptive(*path_, t, *this, norm, 1e-12 * size)) {
      throw std::runtime_error("the acceleration is not finite, or changes too suddenly, after " +
                               std::to_string(path_->t) + " seconds");
    }
    return {path_->position(t), path_->velocity(t)};
  }

  /// The derivatives of the acceleration, by differences.
  template <class Add>
  void jacobian(const Moved& x, const Moved& v, double t, Add&& add) const {
    for (int j = 0; j < unknowns(); ++j) {
      const double dx = step(at(x, j)), dv = step(at(v, j));
      const Moved by_x =
          ((*this)(moved(x, j, dx), v, t) - (*this)(moved(x, j, -dx), v, t)) / (2 * dx);
      const Moved by_v =
          ((*this)(x, moved(v, j, dv), t) - (*this)(x, moved(v, j, -dv), t)) / (2 * dv);
      for (int i = 0; i < unknowns(); ++i) add(i, j, at(by_x, i), at(by_v, i));
    }
  }

  /// Evaluations of the acceleration for its derivatives.
  long evaluations_of_jacobian() const { return 4 * unknowns(); }

 private:
  static double step(double value) { return 6e-6 * (1 + std::abs(value)); }  // cube root of epsilon

  static int unknowns() { return numbers_in(Moved(Vec(start_x))); }
  static double at(Moved vec, int i) { return numbers_of(vec)[i]; }
  static Moved moved(Moved vec, int i, double by) {
    numbers_of(vec)[i] += by;
    return vec;
  }

  mutable std::optional<integrate::Dopri5Path<Moved, double, double>> path_;
};
