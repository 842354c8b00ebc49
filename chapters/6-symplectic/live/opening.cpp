// SPDX-License-Identifier: MIT-0
// The undamped spring of chapter 6 under symplectic Euler, and the curve on which its points lie.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "6-symplectic/shadow.h"
#include "live/figure.h"

namespace live {
namespace {

// A state is a point of the plane of stretch and velocity over omega, and time is counted in steps.
class Opening final : public Figure {
  static constexpr int directions = 720;  // in which the curve is looked for

  double homega_ = 1.5, x_ = 1, u_ = 0;
  long steps_ = 0;
  double farthest_ = 0;
  scenes::Spring<> spring_{.omega = 1, .zeta = 0};
  scenes::State<double> now_;

  std::vector<Setting> settings() override {
    return {{"homega", &homega_}, {"start x", &x_}, {"start u", &u_}};
  }

  void start() override {
    steps_ = 0;
    now_ = {x_, u_};
    farthest_ = std::abs(x_);
    show("size", std::sqrt(x_ * x_ + u_ * u_));
    show_curve();
    show_state();
  }

  // In time that is counted in 1 / omega, the velocity is that over omega, and h is h omega.
  void step() override {
    measure::symplectic_euler(now_.x, now_.v, 0.0, homega_, spring_);
    farthest_ = std::max(farthest_, std::abs(now_.x));
    ++steps_;
  }

  void show_state() override {
    show("t", double(steps_));
    show("h", 1);
    show("x", now_.x);
    show("u", now_.v);
    show("farthest", farthest_);
    const auto shadow = shadow_energy(spring_, homega_);
    const double energy = spring_.energy(x_, u_), kept = shadow(x_, u_);
    show("energy", spring_.energy(now_.x, now_.v) / energy);
    // Far out it is the difference of terms that have no digits left for it.
    show("shadow", farthest_ < 1e4 ? shadow(now_.x, now_.v) / kept : NAN);
  }

  // Where the shadow energy is that of the start: so far out in each direction, or nowhere.
  void show_curve() {
    const auto shadow = shadow_energy(spring_, homega_);
    const double kept = shadow(x_, u_);
    std::vector<double> xs, us;
    for (int i = 0; i <= directions; ++i) {
      const double angle = 2 * std::numbers::pi * i / directions;
      const double x = std::cos(angle), u = std::sin(angle);
      const double far = std::sqrt(kept / shadow(x, u));
      xs.push_back(far * x);
      us.push_back(far * u);
    }
    show_reference("curve x", xs);
    show_reference("curve u", us);
  }
};

}  // namespace

std::unique_ptr<Figure> make_opening() {
  return std::make_unique<Opening>();
}

}  // namespace live
