// SPDX-License-Identifier: MIT-0
/// @file
/// One step of a method on the drone of chapter 2, one look at the acceleration at a time.
#pragma once
#include <vector>

#include "cast.h"
#include "live/figure.h"
#include "live/run.h"

namespace live {

/// The drone's acceleration, and a note of each time that somebody asks for it.
struct Watched {
  using Vec = Eigen::Vector2d;

  /// Where a method looks, with which velocity, when and what it finds there.
  struct Look {
    Vec x, v, a;
    double t;
  };
  std::vector<Look>* looks;

  Vec operator()(const Vec& x, const Vec& v, double t) const {
    looks->push_back({x, v, drone(x, v, t), t});
    return looks->back().a;
  }
  /// Hands the derivatives on, for the implicit methods.
  void jacobian(const Vec& x, const Vec& v, double t, auto&& add) const {
    drone.jacobian(x, v, t, add);
  }
};

/// A step from where the reader puts the drone, as long as the reader wants. At time n the method
/// has looked n times, and one later it is at its end.
template <class Step>
class OneStep final : public Figure {
  using Vec = Eigen::Vector2d;

  Step step_;
  double h_ = 1, x_ = drone.radius, y_ = 0;  // [s], [m], [m]
  scenes::State<Vec> end_;
  std::vector<Watched::Look> looks_;
  std::size_t done_ = 0;

 public:
  explicit OneStep(Step step) : step_(step) {}

 private:
  std::vector<Setting> settings() override {
    return {{"step", &h_}, {"start x", &x_}, {"start y", &y_}};
  }

  // On a circle around the tower, whichever it is.
  void start() override {
    end_ = {{x_, y_}, drone.omega * Vec{-y_, x_}};
    looks_.clear();
    take_step();
    done_ = 0;
    show_step();
    show_state();
  }

  // With what stands in the place of the method, if anything does.
  void take_step() {
    const Watched watched{&looks_};
    if constexpr (requires { Step::function; }) {
      if (is_stood_in_for<Vec>(Step::function)) {
        end_ = measure::after(StandIn(), watched, end_, h_, 1);
        return;
      }
    }
    step_(end_.x, end_.v, 0.0, h_, watched);
  }

  void step() override { done_ = (done_ + 1) % (looks_.size() + 2); }

  void show_state() override {
    show("t", double(done_));
    show("h", 1);
  }

  void show_step() {
    show("seconds", double(looks_.size() + 1));
    show("omega", drone.omega);
    show_all("look x", [](const auto& look) { return look.x.x(); });
    show_all("look y", [](const auto& look) { return look.x.y(); });
    show_all("look u", [](const auto& look) { return look.v.x(); });
    show_all("look v", [](const auto& look) { return look.v.y(); });
    show_all("look a", [](const auto& look) { return look.a.norm(); });
    show_all("look t", [](const auto& look) { return look.t; });
    show("end x", end_.x.x());
    show("end y", end_.x.y());
    std::vector<double> xs, ys;
    for (int i = 0; i <= 60; ++i) {
      const Vec x = truth(h_ * i / 60);
      xs.push_back(x.x());
      ys.push_back(x.y());
    }
    show_reference("true x", xs);
    show_reference("true y", ys);
    show_reference("error", (end_.x - truth(h_)).norm());
  }

  template <class Part>
  void show_all(const char* name, Part part) {
    std::vector<double> values;
    for (const auto& look : looks_) values.push_back(part(look));
    show(name, values);
  }

  // The circle's place after some time.
  Vec truth(double t) const {
    const auto [turned, along] = scenes::Circle<>{drone.omega, 1}.exact(t);
    return {turned.x() * x_ - turned.y() * y_, turned.y() * x_ + turned.x() * y_};
  }
};

}  // namespace live
