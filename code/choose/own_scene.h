// SPDX-License-Identifier: MIT-0
/// @file
/// A scene of the reader's own: from an acceleration and a start, all that the contest asks of a
/// scene.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "choose/own_force.h"
#include "integrate/dopri5.h"
#include "measure/length.h"
#include "scenes/state.h"

/// The reader's scene, with a truth and derivatives that are found by running it.
/// @tparam Moved  the type that the methods move: they are compiled for `double`, Eigen::Vector2d
/// and Eigen::VectorXd
template <class Moved>
class OwnScene {
 public:
  /// @param force  the reader's
  /// @param begin  when what is asked of this begins, in the reader's time [s]
  explicit OwnScene(const OwnForce& force, double begin = 0)
      : force_(force), begin_(begin), start_{zero(), zero()} {
    force_.start(numbers_of(start_.x), numbers_of(start_.v));
    if (begin > 0) start_ = OwnScene(force).exact(begin);
  }

  /// The acceleration.
  Moved operator()(const Moved& x, const Moved& v, double t) const {
    Moved a = zero();
    force_.acceleration(numbers_of(x), numbers_of(v), begin_ + t, numbers_of(a));
    return a;
  }

  /// The start.
  scenes::State<Moved> start() const { return start_; }

  /// The truth at a time, by Dormand-Prince.
  /// @throws std::runtime_error  it gets no farther, since the acceleration is not finite, or jumps
  scenes::State<Moved> exact(double t) const {
    // Never back in time: what a damper took away comes back with all errors magnified.
    if (!path_ || t < path_->t_before)
      path_ = integrate::dopri5_path(start_.x, start_.v, 0.0, 1e-3, *this);
    const auto norm = [](const Moved& error) { return measure::length(error); };
    const double size = 1 + measure::length(start_.x) + measure::length(start_.v);
    if (!integrate::dopri5_adaptive(*path_, t, *this, norm, tolerance() * size)) {
      throw std::runtime_error("the acceleration is not finite, or changes too suddenly, after " +
                               std::to_string(begin_ + path_->t) + " seconds");
    }
    return {path_->position(t), path_->velocity(t)};
  }

  /// The derivatives of the acceleration, by differences.
  template <class Add>
  void jacobian(const Moved& x, const Moved& v, double t, Add&& add) const {
    for (int j = 0; j < force_.numbers; ++j) {
      const double dx = step(at(x, j)), dv = step(at(v, j));
      const Moved by_x =
          ((*this)(moved(x, j, dx), v, t) - (*this)(moved(x, j, -dx), v, t)) / (2 * dx);
      const Moved by_v =
          ((*this)(x, moved(v, j, dv), t) - (*this)(x, moved(v, j, -dv), t)) / (2 * dv);
      for (int i = 0; i < force_.numbers; ++i) add(i, j, at(by_x, i), at(by_v, i));
    }
  }

  /// The finest tolerance that adaptive steps are tried with, as a share of the motion: a finer one
  /// would chase the rounding of floats.
  double finest_tolerance() const { return force_.in_float ? 1e-7 : 0; }

  /// Evaluations of the acceleration for its derivatives.
  long evaluations_of_jacobian() const { return 4L * force_.numbers; }

 private:
  // The truth of floats is no better than they are.
  double tolerance() const { return force_.in_float ? 1e-9 : 1e-12; }

  // Cube root of the rounding.
  double step(double value) const {
    return (force_.in_float ? 5e-3 : 6e-6) * (1 + std::abs(value));
  }

  Moved zero() const {
    if constexpr (std::is_same_v<Moved, double>) {
      return 0;
    } else {
      return Moved::Zero(force_.numbers);
    }
  }

  static double* numbers_of(double& x) { return &x; }
  static const double* numbers_of(const double& x) { return &x; }
  static double* numbers_of(auto& x) { return x.data(); }
  static const double* numbers_of(const auto& x) { return x.data(); }

  static double at(const Moved& vec, int i) { return numbers_of(vec)[i]; }
  static Moved moved(Moved vec, int i, double by) {
    numbers_of(vec)[i] += by;
    return vec;
  }

  OwnForce force_;
  double begin_;
  scenes::State<Moved> start_;
  mutable std::optional<integrate::Dopri5Path<Moved, double, double>> path_;
};
