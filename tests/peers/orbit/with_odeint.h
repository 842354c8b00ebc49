// SPDX-License-Identifier: MIT-0
// Boost.odeint, on its own recommendation for small states (std::array) and on Eigen's vectors.
// Many planets share one stepper, and each keeps what a stepper would remember of it.
#pragma once
#include <Eigen/Core>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <boost/numeric/odeint/external/eigen/eigen.hpp>
#include <functional>
#include <utility>
#include <vector>

#include "orbit/state.h"

namespace orbit::with_odeint {

namespace odeint = boost::numeric::odeint;

/// The Runge-Kutta methods, on position and velocity in one state of four numbers.
template <class Stepper>
class FirstOrder {
 public:
  using Shared = Stepper;
  explicit FirstOrder(State s) : y_{s.x, s.y, s.vx, s.vy} {}
  void step(Stepper& stepper, double t, double h) { stepper.do_step(slope, y_, t, h); }
  State state() const { return {y_[0], y_[1], y_[2], y_[3]}; }

 protected:
  using Four = typename Stepper::state_type;
  static constexpr auto slope = [](const Four& y, Four& slope, double) {
    const double p = pull(y[0] * y[0] + y[1] * y[1]);
    slope[0] = y[2];
    slope[1] = y[3];
    slope[2] = p * y[0];
    slope[3] = p * y[1];
  };
  Four y_;
};

/// Dormand and Prince: the slope at the end is that of the next start.
template <class Stepper>
class Dopri5 : public FirstOrder<Stepper> {
 public:
  explicit Dopri5(State s) : FirstOrder<Stepper>(s) { this->slope(this->y_, slope_, 0); }
  void step(Stepper& stepper, double t, double h) {
    stepper.do_step(this->slope, this->y_, slope_, t, h);
  }

 private:
  typename Stepper::deriv_type slope_;
};

/// Its symplectic_euler moves the position first. Told that the velocity is the position, and the
/// other way round, it moves the velocity first, as the other rows do.
template <class Two>
class SymplecticEuler {
 public:
  using Shared = odeint::symplectic_euler<Two>;
  explicit SymplecticEuler(State s) : x_{s.x, s.y}, v_{s.vx, s.vy} {}
  void step(Shared& stepper, double t, double h) {
    const auto acceleration = [](const Two& x, Two& a) {
      const double p = pull(x[0] * x[0] + x[1] * x[1]);
      a[0] = p * x[0];
      a[1] = p * x[1];
    };
    const auto velocity = [](const Two& v, Two& slope) { slope = v; };
    const auto slopes = std::make_pair(acceleration, velocity);
    stepper.do_step(slopes, v_, x_, t, h);
  }
  State state() const { return {x_[0], x_[1], v_[0], v_[1]}; }

 private:
  Two x_, v_;
};

template <class Two>
class VelocityVerlet {
 public:
  using Shared = odeint::velocity_verlet<Two>;
  explicit VelocityVerlet(State s) : x_{s.x, s.y}, v_{s.vx, s.vy} { accelerate(x_, v_, a_, 0); }
  void step(Shared& stepper, double t, double h) {
    Two a_end;
    stepper.do_step(accelerate, x_, v_, a_, x_, v_, a_end, t, h);
    a_ = a_end;
  }
  State state() const { return {x_[0], x_[1], v_[0], v_[1]}; }

 private:
  static constexpr auto accelerate = [](const Two& x, const Two&, Two& a, double) {
    const double p = pull(x[0] * x[0] + x[1] * x[1]);
    a[0] = p * x[0];
    a[1] = p * x[1];
  };
  Two x_, v_, a_;
};

/// All planets as one state of so many numbers.
template <class Stepper>
std::vector<State> whole(const std::vector<State>& from, long steps, double h) {
  std::vector<double> y;
  for (const State& s : from) y.insert(y.end(), {s.x, s.y, s.vx, s.vy});
  const auto slope = [](const std::vector<double>& now, std::vector<double>& slopes, double) {
    for (std::size_t i = 0; i < now.size(); i += 4) {
      const double p = pull(now[i] * now[i] + now[i + 1] * now[i + 1]);
      slopes[i] = now[i + 2];
      slopes[i + 1] = now[i + 3];
      slopes[i + 2] = p * now[i];
      slopes[i + 3] = p * now[i + 1];
    }
  };
  Stepper stepper;
  for (long n = 0; n < steps; ++n) stepper.do_step(slope, y, double(n) * h, h);
  std::vector<State> end;
  for (std::size_t i = 0; i < y.size(); i += 4) end.push_back({y[i], y[i + 1], y[i + 2], y[i + 3]});
  return end;
}

}  // namespace orbit::with_odeint
